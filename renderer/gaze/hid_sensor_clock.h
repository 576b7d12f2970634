// Converts the time that a sensor stamps on its reports to the host's.
#pragma once

#include <optional>

#include "renderer/base/clock.h"
#include "renderer/gaze/sliding_minimum.h"

namespace foveola {

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

  /// Seconds of the sensor's clock from the report before the last one to the last one; empty if
  /// the two cannot be compared.
  std::optional<double> last_interval_s() const { return last_interval_s_; }

 private:
  /// The sensor's time, as if it had never started again.
  double continued(double sensor_time_s);

  std::optional<double> period_s_;
  double periods_s_ = 0.0;  ///< those that are over
  std::optional<double> last_s_;
  std::optional<double> last_interval_s_;
  /// By how many seconds the host's clock was ahead of the sensor's as reports arrived.
  SlidingMinimum<double> ahead_s_{std::chrono::seconds(5)};
};

}  // namespace foveola
