// Reads a study's trials with what was measured in each of their timings.
#pragma once

#include <cstdint>
#include <vector>

#include "study/record/study_records.h"

namespace SQLite {
class Database;
}

namespace foveola::study {

/// Fills the records' trials, values and words; their scenes, methods, measures and sessions must
/// be there, and `session_ids` has the sessions' row ids in the same order. Withdrawn sessions are
/// left out. Throws what SQLite throws.
void read_trial_rows(SQLite::Database& database, const std::vector<std::int64_t>& session_ids,
                     StudyRecords& records);

}  // namespace foveola::study
