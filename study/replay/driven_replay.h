// A recorded session driven again: the driver's clock shows the recorded times, its input gives the
// recorded answers, and the events that it makes are compared with the recorded ones.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "study/driver/ports.h"
#include "study/record/recorded_session.h"

namespace foveola::study {

/// What is driven again; all of it must outlive the drive.
struct DrivenRecord {
  const RecordedSession& session;
  const Protocol& protocol;
  /// The protocol by which the session went on after its words or times were amended.
  std::function<Protocol(const Amendment& amendment)> amended;
  /// Shows an attempt, all of whose frames are shown once it has finished. Null: it is not shown.
  std::function<std::unique_ptr<AttemptPort>(const RecordedAttempt& attempt)> begin_attempt;
};

/// Drives the session, run by run of the program that recorded it, until its record ends or `stop`
/// is requested. Returns how the first event that is another one differs; empty if all are the
/// same.
std::string drive_again(const DrivenRecord& record, const std::stop_token& stop);

}  // namespace foveola::study
