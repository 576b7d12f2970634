// Drives a recorded session again: the clock shows the recorded times, the input gives the recorded
// answers, and the resulting events are compared with the recorded ones.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "study/driver/ports.h"
#include "study/record/recorded_session.h"

namespace foveola::study {

/// Inputs of the drive; all must outlive it.
struct DrivenRecord {
  const RecordedSession& session;
  const Protocol& protocol;
  /// Returns the protocol that the session followed after an amendment.
  std::function<Protocol(const Amendment& amendment)> amended;
  /// Begins to show an attempt, all of whose frames are shown once it has finished. Null: attempts
  /// are not shown.
  std::function<std::unique_ptr<AttemptPort>(const RecordedAttempt& attempt)> begin_attempt;
};

/// Drives the session, run by run of the recording program, until its record ends or `stop` is
/// requested. Returns a description of the first differing event; empty if all are equal.
std::string drive_again(const DrivenRecord& record, const std::stop_token& stop);

}  // namespace foveola::study
