// How regularly a tracker's samples come.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "renderer/base/clock.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// Looks at the samples of the last while, by their own times.
class InterSampleIntervals {
 public:
  /// Over how many intervals the figures below are taken.
  static constexpr std::size_t window = 240;

  /// Adds a sample unless it is older than the one before, or as old.
  void add(const GazeSample& sample);

  /// All so far.
  std::uint64_t samples() const { return samples_; }
  std::uint64_t valid_samples() const { return valid_samples_; }
  /// Intervals longer than one and a half times the usual one, so far: samples that never came.
  std::uint64_t gaps() const { return gaps_; }

  /// The reciprocal of the median interval; empty before two samples.
  std::optional<double> rate_hz() const;
  /// The intervals' mean absolute deviation from their median.
  std::optional<double> jitter_ms() const;

 private:
  std::optional<double> median_interval_s() const;

  std::optional<Nanoseconds> last_time_;
  std::deque<double> intervals_s_;
  std::uint64_t samples_ = 0;
  std::uint64_t valid_samples_ = 0;
  std::uint64_t gaps_ = 0;
};

}  // namespace foveola
