// Converts devices' times to the host's, by the minimum over a sliding window.
#pragma once

#include <deque>
#include <optional>

#include "renderer/base/clock.h"

namespace foveola {

/// The minimum of the values whose times are at most `window` before the newest. Each is added and
/// dropped once.
template <typename Value>
class SlidingMinimum {
 public:
  explicit SlidingMinimum(Nanoseconds window) : window_(window) {}

  /// Times may not go backwards.
  void add(Nanoseconds time, const Value& value) {
    while (!candidates_.empty() && candidates_.back().value >= value) {
      candidates_.pop_back();
    }
    candidates_.push_back({time, value});
    while (time - candidates_.front().time > window_) {
      candidates_.pop_front();
    }
  }

  /// The minimum; there must be at least one value.
  const Value& least() const { return candidates_.front().value; }

  void clear() { candidates_.clear(); }

 private:
  struct Candidate {
    Nanoseconds time{0};
    Value value;
  };

  Nanoseconds window_;
  /// Those that are or may become the least: times and values ascend.
  std::deque<Candidate> candidates_;
};

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

/// Follows a clock whose origin is not known and which may run slightly fast or slow. A report can
/// be late, never early: of those that arrived within the last five seconds, the one with the
/// shortest way is taken to have had none, and shows how far the two clocks are apart.
///
/// A sensor clock that jumps back or stands still makes reports seem ever later. Once one seems
/// more than a second late, longer than 60 Hz need to fill the 64 reports that Linux queues, the
/// clocks are compared anew from there on.
class HidSensorClock {
 public:
  /// period_s: the sensor's clock starts again from 0 after so many seconds; empty if never.
  explicit HidSensorClock(std::optional<double> period_s = {}) : period_s_(period_s) {}

  /// When the report stamped `sensor_time_s` would have arrived with no delay but the shortest; in
  /// [arrival - 1 s, arrival]. Arrivals may not go backwards between calls.
  Nanoseconds host_time(double sensor_time_s, Nanoseconds arrival);

 private:
  /// The sensor's time, as if it had never started again.
  double continued(double sensor_time_s);

  std::optional<double> period_s_;
  double periods_s_ = 0.0;  ///< those that are over
  std::optional<double> last_s_;
  /// By how many seconds the host's clock was ahead of the sensor's as reports arrived.
  SlidingMinimum<double> ahead_s_{std::chrono::seconds(5)};
};

}  // namespace foveola
