// What happened in a session, read back from its record.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "study/record/prepared_statements.h"
#include "study/record/study_store.h"

namespace foveola::study {

/// A session's events in their order, with all that they said. Throws Error, whose place is the
/// session, for one that this program cannot read; and what SQLite throws.
std::vector<LoggedEvent> events_of(SQLite::Database& database, std::int64_t session);

/// Called with an event, and the states that it led from and to.
using StepVisitor = std::function<void(const LoggedEvent& logged, const SessionState& before,
                                       const SessionState& after)>;

/// Goes through a session again, event by event. whose: names the session in errors. Throws Error
/// for an event that cannot follow those before it.
void for_each_step(const Procedure& procedure, const std::vector<LoggedEvent>& events,
                   const std::string& whose, const StepVisitor& visit);

/// Makes everything that follows from `events`, which is all but their log, in a database that
/// holds the session and its plan, but nothing that happened yet. Throws Error for an event that
/// cannot follow those before it.
void replay_events(PreparedStatements& statements, std::int64_t session, const Procedure& procedure,
                   const std::vector<LoggedEvent>& events);

}  // namespace foveola::study
