// Estimates the duration of a session from the protocol's numbers and assumed times of people.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/protocol/protocol.h"

namespace foveola::study {

struct Duration {
  double least_s = 0.0;
  double most_s = 0.0;
};

/// An assumed duration that the protocol does not state.
struct AssumedDuration {
  std::string_view of;
  Duration duration;
};
std::span<const AssumedDuration> assumed_durations();

/// One of a session's phases, or its practice, test or catch trials.
struct SessionPart {
  std::string name;
  int count = 1;  ///< Number of trials, questions, presses or targets.
  Duration duration;
};

/// Returns the parts of a session with their minimum and maximum durations. Minimum: every
/// validation passes at once. Maximum: each mark times out and every validation but the last fails.
/// Pauses and retiming are not counted.
std::vector<SessionPart> session_parts(const Protocol& protocol);

Duration total_of(const std::vector<SessionPart>& parts);

}  // namespace foveola::study
