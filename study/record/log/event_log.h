// The log of what happened in a session: appends to it, reads it, and goes through it again.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/record/log/hash_chain.h"
#include "study/record/sqlite/prepared_statements.h"
#include "study/record/write/study_store.h"
#include "study/session/session.h"

namespace foveola::study {

/// What schema.sql describes at event: how many frames, gaze samples and film hashes the tables
/// hold of the attempt, and digests of them. Throws what SQLite throws.
std::string measured_in(PreparedStatements& statements, std::int64_t session, std::int64_t trial,
                        std::int64_t attempt);

/// Where an event that took a session from one state to the other happened, and what it states.
struct EventAttempt {
  std::optional<std::int64_t> trial;
  std::optional<std::int64_t> attempt;
  std::string measured;  ///< empty if it ends no attempt
};
EventAttempt attempt_of_event(PreparedStatements& statements, std::int64_t session,
                              const Procedure& procedure, const SessionState& before,
                              const SessionState& after);

/// Appends `line`, whose hash is `hash`, to the log of the session's events. Throws what SQLite
/// throws.
void insert_line(PreparedStatements& statements, std::int64_t session, const LogLine& line,
                 const std::string& hash);

/// Appends `logged`, which took the session from `before` to `after`, to its log and its hash
/// chain, and writes the session's state. Call it inside a transaction. Throws what SQLite throws.
void append_event(PreparedStatements& statements, std::int64_t session, const Procedure& procedure,
                  const LoggedEvent& logged, const SessionState& before, const SessionState& after);

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

}  // namespace foveola::study
