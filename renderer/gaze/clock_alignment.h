// Converts a tracker's time to the host's, when only the arrivals of its messages are known.
#pragma once

#include <optional>

#include "renderer/base/clock.h"
#include "renderer/gaze/sliding_minimum.h"

namespace foveola {

/// Takes the fastest delivery of the last while for the one without delay: what comes later than
/// the tracker's clock lets expect has waited on its way. The window lets the clocks drift apart:
/// by 50 millionths, half a millisecond in ten seconds.
class ClockAlignment {
 public:
  /// window: > 0.
  explicit ClockAlignment(Nanoseconds window);

  /// When, by the host's clock, the tracker's clock showed `tracker_time` in a message that arrived
  /// at `arrival`, as if the fastest one had taken no time; never after `arrival`. Arrivals may not
  /// go backwards. If the tracker's clock does, it was set anew, and so is the alignment.
  Nanoseconds host_time(Nanoseconds tracker_time, Nanoseconds arrival);

 private:
  std::optional<Nanoseconds> last_tracker_time_;
  SlidingMinimum<Nanoseconds> offsets_;  ///< arrivals less the tracker's times
};

}  // namespace foveola
