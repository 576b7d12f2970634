// Converts devices' times to the host's, by the minimum over a sliding window.
#pragma once

#include <deque>
#include <optional>

#include "renderer/base/clock.h"

namespace foveola {

/// The minimum over all values whose times are at most `window` before the newest. Amortised
/// constant time per value.
template <typename Value>
class SlidingMinimum {
 public:
  explicit SlidingMinimum(Nanoseconds window) : window_(window) {}

  /// Times must not decrease.
  void add(Nanoseconds time, const Value& value) {
    while (!candidates_.empty() && candidates_.back().value >= value) {
      candidates_.pop_back();
    }
    candidates_.push_back({time, value});
    while (time - candidates_.front().time > window_) {
      candidates_.pop_front();
    }
  }

  /// The minimum of at least one value.
  const Value& least() const { return candidates_.front().value; }

  void clear() { candidates_.clear(); }

 private:
  struct Candidate {
    Nanoseconds time{0};
    Value value;
  };

  Nanoseconds window_;
  /// Candidates for the minimum: times and values ascend.
  std::deque<Candidate> candidates_;
};

/// Takes the fastest recent delivery as the one without delay; a later arrival than the tracker's
/// clock predicts was delayed. The window allows for clock drift: 50 millionths are half a
/// millisecond in ten seconds.
class ClockAlignment {
 public:
  /// window: > 0.
  explicit ClockAlignment(Nanoseconds window);

  /// Host time at which the tracker's clock showed `tracker_time`, for a message that arrived at
  /// `arrival`, assuming no delay of the fastest one; never after `arrival`. Arrivals must not
  /// decrease. If the tracker's clock decreases, it was reset, and the alignment begins anew.
  Nanoseconds host_time(Nanoseconds tracker_time, Nanoseconds arrival);

 private:
  std::optional<Nanoseconds> last_tracker_time_;
  SlidingMinimum<Nanoseconds> offsets_;  ///< arrivals minus the tracker's times
};

/// Tracks a clock of unknown origin and slight drift. A report can be late, never early: of those
/// of the last five seconds, the fastest counts as without delay, and gives the offset between the
/// two clocks.
///
/// A sensor clock that jumps back or stops makes reports seem ever later. If one seems more than a
/// second late, longer than 60 Hz need to fill the 64 reports that Linux queues, the offset is
/// measured anew.
class HidSensorClock {
 public:
  /// period_s: the sensor's clock wraps to 0 after this time; nullopt if never.
  explicit HidSensorClock(std::optional<double> period_s = {}) : period_s_(period_s) {}

  /// Host time of the report stamped `sensor_time_s`, assuming the minimum delay; in [arrival - 1
  /// s, arrival]. Arrivals must not decrease between calls.
  Nanoseconds host_time(double sensor_time_s, Nanoseconds arrival);

 private:
  /// The sensor's time without wrapping.
  double continued(double sensor_time_s);

  std::optional<double> period_s_;
  double periods_s_ = 0.0;  ///< sum of the completed periods
  std::optional<double> last_s_;
  /// Seconds of the host's clock ahead of the sensor's at each arrival.
  SlidingMinimum<double> ahead_s_{std::chrono::seconds(5)};
};

}  // namespace foveola
