#include "renderer/gaze/hid_sensor_clock.h"

namespace foveola {
namespace {

constexpr Nanoseconds comparison_window = std::chrono::seconds(5);
constexpr double longest_delay_s = 1.0;

}  // namespace

Nanoseconds HidSensorClock::host_time(double sensor_time_s, Nanoseconds arrival) {
  const double time_s = continued(sensor_time_s);
  last_interval_s_ = last_s_ ? std::optional(time_s - *last_s_) : std::nullopt;
  last_s_ = time_s;
  const Comparison comparison{.arrival = arrival, .ahead_s = seconds(arrival) - time_s};
  compare(comparison);
  const double delay_s = comparison.ahead_s - window_.front().ahead_s;
  if (delay_s <= longest_delay_s) {
    return arrival - nanoseconds_from_seconds(delay_s);
  }
  ++restarts_;
  last_interval_s_.reset();
  window_.assign(1, comparison);
  return arrival;
}

double HidSensorClock::continued(double sensor_time_s) {
  if (period_s_ && last_s_ && *last_s_ - periods_s_ - sensor_time_s > 0.5 * *period_s_) {
    periods_s_ += *period_s_;
  }
  return sensor_time_s + periods_s_;
}

void HidSensorClock::compare(const Comparison& comparison) {
  while (!window_.empty() && window_.back().ahead_s >= comparison.ahead_s) {
    window_.pop_back();
  }
  window_.push_back(comparison);
  while (comparison.arrival - window_.front().arrival > comparison_window) {
    window_.pop_front();
  }
}

}  // namespace foveola
