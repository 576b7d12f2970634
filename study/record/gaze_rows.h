// The runs of a gaze validation as rows of the record.
#pragma once

#include <cstdint>
#include <vector>

#include "study/session/session.h"

namespace SQLite {
class Database;
}

namespace foveola::study {

/// Appends the runs that the session's event number `sequence` reports. Call it inside a
/// transaction. Throws what SQLite throws.
void insert_gaze_runs(SQLite::Database& database, std::int64_t session, std::int64_t sequence,
                      const std::vector<GazeRun>& runs);

}  // namespace foveola::study
