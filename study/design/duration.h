// How long a session takes: the protocol's own numbers, and what people are assumed to need.
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

/// What the protocol does not say, and nobody has measured here.
struct AssumedDuration {
  std::string_view of;
  Duration duration;
};
std::span<const AssumedDuration> assumed_durations();

/// One of a session's phases, or its practice, test or catch trials.
struct SessionPart {
  std::string name;
  int count = 1;  ///< of trials, questions, presses or targets
  Duration duration;
};

/// At least: every validation passes at once. At most: each mark times out and every validation but
/// the last fails. Without pauses and without anything timed again.
std::vector<SessionPart> session_parts(const Protocol& protocol);

Duration total_of(const std::vector<SessionPart>& parts);

}  // namespace foveola::study
