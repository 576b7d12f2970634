#include "renderer/gaze/inter_sample_intervals.h"

#include <cmath>

#include "renderer/base/quantile.h"

namespace foveola {

void InterSampleIntervals::add(const GazeSample& sample) {
  if (last_time_ && sample.time <= *last_time_) {
    return;
  }
  ++samples_;
  valid_samples_ += sample.valid ? 1 : 0;
  if (last_time_) {
    constexpr double gap_intervals = 1.5;
    const double interval_s = seconds(sample.time - *last_time_);
    const std::optional<double> usual_s = median_interval_s();
    gaps_ += usual_s && interval_s > gap_intervals * *usual_s ? 1 : 0;
    intervals_s_.push_back(interval_s);
    if (intervals_s_.size() > window) {
      intervals_s_.pop_front();
    }
  }
  last_time_ = sample.time;
}

std::optional<double> InterSampleIntervals::rate_hz() const {
  const std::optional<double> interval_s = median_interval_s();
  return interval_s ? std::optional(1.0 / *interval_s) : std::nullopt;
}

std::optional<double> InterSampleIntervals::jitter_ms() const {
  const std::optional<double> usual_s = median_interval_s();
  if (!usual_s) {
    return std::nullopt;
  }
  double sum_s = 0.0;
  for (const double interval_s : intervals_s_) {
    sum_s += std::abs(interval_s - *usual_s);
  }
  constexpr double ms_per_s = 1e3;
  return ms_per_s * sum_s / static_cast<double>(intervals_s_.size());
}

std::optional<double> InterSampleIntervals::median_interval_s() const {
  return upper_median({intervals_s_.begin(), intervals_s_.end()});
}

}  // namespace foveola
