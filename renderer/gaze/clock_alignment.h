// From a tracker's clock to the host's, when all that is known of it is what arrives.
#pragma once

#include <deque>
#include <optional>

#include "renderer/base/clock.h"

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
  struct Delivery {
    Nanoseconds arrival{0};
    Nanoseconds offset{0};  ///< the arrival less the tracker's time
  };

  Nanoseconds window_;
  std::optional<Nanoseconds> last_tracker_time_;
  /// Those that are or may become the fastest of the window: both fields ascend.
  std::deque<Delivery> fastest_;
};

}  // namespace foveola
