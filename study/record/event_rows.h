// An event of a session as rows of the record.
#pragma once

#include <cstdint>

#include "renderer/base/clock.h"
#include "study/session/session.h"

namespace SQLite {
class Database;
}

namespace foveola::study {

/// Appends `event`, which took the session from `before` to `after`, to the log, and writes what
/// follows from it. Call it inside a transaction. Throws what SQLite throws.
void insert_event_rows(SQLite::Database& database, std::int64_t session, Nanoseconds time,
                       const Event& event, const SessionState& before, const SessionState& after);

}  // namespace foveola::study
