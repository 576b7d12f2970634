// What was measured in an attempt, as the event that ends it states it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "study/record/prepared_statements.h"
#include "study/session/session.h"

namespace foveola::study {

/// Whether the session is in an attempt at a trial.
bool is_in_attempt(const SessionState& state);

/// Whether both are in one attempt.
bool is_same_attempt(const SessionState& a, const SessionState& b);

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

}  // namespace foveola::study
