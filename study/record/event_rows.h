// An event of a session as rows of the record.
#pragma once

#include <cstdint>

#include "study/record/measured.h"
#include "study/record/prepared_statements.h"
#include "study/record/study_store.h"

namespace foveola::study {

/// Appends `logged`, which happened in an attempt or in none, to the session's log and its hash
/// chain; returns its number there. Call both inside one transaction; they throw what SQLite
/// throws.
std::int64_t append_to_log(PreparedStatements& statements, std::int64_t session,
                           const LoggedEvent& logged, EventAttempt where);

/// Writes what follows from `event`, whose number in the log is `sequence`, and which took the
/// session from `before` to `after`.
void insert_what_follows(PreparedStatements& statements, std::int64_t session,
                         const Procedure& procedure, std::int64_t sequence, const Event& event,
                         const SessionState& before, const SessionState& after);

}  // namespace foveola::study
