// Replays a recorded session through the session driver. The clock shows the recorded times, the
// input gives the recorded answers, and the resulting events are compared with the recorded ones.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "study/driver/ports.h"
#include "study/record/read/recorded_session.h"

namespace foveola::study {

/// Inputs of a replay; all must outlive it.
struct DrivenRecord {
  const RecordedSession& session;
  const Protocol& protocol;
  /// Returns the protocol that the session followed after an amendment.
  std::function<Protocol(const Amendment& amendment)> amended;
  /// Returns a port that shows the attempt's frames, the last of them when the attempt ends; null
  /// to replay the attempt without frames.
  std::function<std::unique_ptr<AttemptPort>(const RecordedAttempt& attempt)> begin_attempt;
};

/// Replays the session until its record ends or `stop` is requested, separately for each run of the
/// program that recorded it. Returns a description of the first differing event; empty if all are
/// equal, or were up to the stop. Passes on what `amended` and `begin_attempt` throw.
std::string replay_events(const DrivenRecord& record, const std::stop_token& stop);

}  // namespace foveola::study
