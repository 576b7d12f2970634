// An event of a session as rows of the record.
#pragma once

#include <cstdint>

#include "study/record/prepared_statements.h"
#include "study/record/study_store.h"

namespace foveola::study {

/// Appends `logged`, whose event took the session from `before` to `after`, to the log and its hash
/// chain, and writes what follows from it. Call it inside a transaction. Throws what SQLite throws.
void insert_event_rows(PreparedStatements& statements, std::int64_t session,
                       const Procedure& procedure, const LoggedEvent& logged,
                       const SessionState& before, const SessionState& after);

}  // namespace foveola::study
