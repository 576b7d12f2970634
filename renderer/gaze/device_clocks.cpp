#include "renderer/gaze/device_clocks.h"

#include <cassert>

namespace foveola {
namespace {

constexpr double longest_delay_s = 1.0;

}  // namespace

ClockAlignment::ClockAlignment(Nanoseconds window) : offsets_(window) {
  assert(window > Nanoseconds::zero());
}

Nanoseconds ClockAlignment::host_time(Nanoseconds tracker_time, Nanoseconds arrival) {
  if (last_tracker_time_ && tracker_time < *last_tracker_time_) {
    offsets_.clear();
  }
  last_tracker_time_ = tracker_time;
  offsets_.add(arrival, arrival - tracker_time);
  return tracker_time + offsets_.least();
}

Nanoseconds HidSensorClock::host_time(double sensor_time_s, Nanoseconds arrival) {
  const double time_s = continued(sensor_time_s);
  last_s_ = time_s;
  const double ahead_s = seconds(arrival) - time_s;
  ahead_s_.add(arrival, ahead_s);
  const double delay_s = ahead_s - ahead_s_.least();
  if (delay_s <= longest_delay_s) {
    return arrival - nanoseconds_from_seconds(delay_s);
  }
  ahead_s_.clear();
  ahead_s_.add(arrival, ahead_s);
  return arrival;
}

double HidSensorClock::continued(double sensor_time_s) {
  if (period_s_ && last_s_ && *last_s_ - periods_s_ - sensor_time_s > 0.5 * *period_s_) {
    periods_s_ += *period_s_;
  }
  return sensor_time_s + periods_s_;
}

}  // namespace foveola
