#include "renderer/gaze/gaze_quality.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/quantile.h"
#include "renderer/base/transformed.h"
#include "renderer/gaze/eye_movements.h"

namespace foveola {
namespace {

/// Minimum number of samples: those of a fixation at the slowest trackers, 30 Hz (assumed).
constexpr std::size_t min_samples = 10;

double angle_deg(const Vec3& a, const Vec3& b) { return degrees(angle_between(a, b)); }

/// The median interval between successive samples, valid or not.
std::optional<double> default_interval_s(std::span<const WatchedTarget> watched) {
  std::vector<double> intervals_s;
  for (const WatchedTarget& target : watched) {
    for (std::size_t i = 1; i < target.samples.size(); ++i) {
      intervals_s.push_back(seconds(target.samples[i].time - target.samples[i - 1].time));
    }
  }
  return upper_median(std::move(intervals_s));
}

double data_loss(const WatchedTarget& target, std::optional<double> interval_s) {
  if (!interval_s || *interval_s <= 0.0 || target.end <= target.start) {
    return 1.0;
  }
  const double expected = seconds(target.end - target.start) / *interval_s;
  const auto valid = static_cast<double>(
      std::ranges::count_if(target.samples, [](const GazeSample& s) { return s.valid; }));
  return std::clamp(1.0 - valid / expected, 0.0, 1.0);
}

/// Rayleigh-distributed velocities, as of noise, exceed six times their median once in 10^10.
EyeMovementSettings settings_for(const std::vector<GazeSample>& samples) {
  constexpr double medians = 6.0;
  EyeMovementSettings settings;
  std::vector<double> velocities_deg_per_s;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const GazeSample& before = samples[i - 1];
    const GazeSample& sample = samples[i];
    if (before.valid && sample.valid && sample.time > before.time) {
      velocities_deg_per_s.push_back(angle_deg(before.direction, sample.direction) /
                                     seconds(sample.time - before.time));
    }
  }
  settings.threshold_deg_per_s =
      std::max(settings.threshold_deg_per_s,
               medians * upper_median(std::move(velocities_deg_per_s)).value_or(0.0));
  return settings;
}

/// The eye at rest.
struct Fixated {
  std::vector<Vec3> directions;
  std::vector<double> steps_deg;  ///< between successive samples without a saccade
};

Fixated fixated(const std::vector<GazeSample>& samples) {
  Fixated fixated;
  EyeMovementDetector detector(settings_for(samples));
  const GazeSample* last = nullptr;
  for (const GazeSample& sample : samples) {
    detector.push(sample);
    if (!sample.valid) {
      continue;
    }
    if (detector.now() != EyeMovementKind::fixation) {
      last = nullptr;
      continue;
    }
    if (last != nullptr) {
      fixated.steps_deg.push_back(angle_deg(last->direction, sample.direction));
    }
    fixated.directions.push_back(sample.direction);
    last = &sample;
  }
  return fixated;
}

Vec3 mean_direction(const std::vector<Vec3>& directions) {
  DVec3 sum(0.0);
  for (const Vec3& direction : directions) {
    sum += DVec3(direction);
  }
  return Vec3(glm::normalize(sum));
}

double mean_angle_deg(const std::vector<Vec3>& directions, const Vec3& from) {
  double sum_deg = 0.0;
  for (const Vec3& direction : directions) {
    sum_deg += angle_deg(direction, from);
  }
  return sum_deg / static_cast<double>(directions.size());
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value * value;
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double deviation_deg(const std::vector<Vec3>& directions, const Vec3& mean) {
  const std::vector<double> angles_deg =
      transformed(directions, [&](const Vec3& direction) { return angle_deg(direction, mean); });
  return root_mean_square(angles_deg);
}

std::optional<SeenTarget> seen_target(const WatchedTarget& target) {
  const Fixated gaze = fixated(target.samples);
  if (gaze.directions.size() < min_samples || gaze.steps_deg.empty()) {
    return std::nullopt;
  }
  const Vec3 mean = mean_direction(gaze.directions);
  return SeenTarget{.mean_gaze = mean,
                    .samples = gaze.directions.size(),
                    .figures = {.accuracy_deg = mean_angle_deg(gaze.directions, target.direction),
                                .precision_rms_deg = root_mean_square(gaze.steps_deg),
                                .precision_sd_deg = deviation_deg(gaze.directions, mean)}};
}

std::optional<GazeFigures> figures_of(const std::vector<TargetQuality>& targets) {
  double accuracies_deg = 0.0;
  std::vector<double> steps_deg;
  std::vector<double> deviations_deg;
  for (const TargetQuality& target : targets) {
    if (target.seen) {
      accuracies_deg += target.seen->figures.accuracy_deg;
      steps_deg.push_back(target.seen->figures.precision_rms_deg);
      deviations_deg.push_back(target.seen->figures.precision_sd_deg);
    }
  }
  if (steps_deg.empty()) {
    return std::nullopt;
  }
  return GazeFigures{.accuracy_deg = accuracies_deg / static_cast<double>(steps_deg.size()),
                     .precision_rms_deg = root_mean_square(steps_deg),
                     .precision_sd_deg = root_mean_square(deviations_deg)};
}

}  // namespace

GazeQuality gaze_quality(std::span<const WatchedTarget> watched) {
  assert(!watched.empty());
  const std::optional<double> interval_s = default_interval_s(watched);
  GazeQuality quality;
  double losses = 0.0;
  for (const WatchedTarget& target : watched) {
    quality.targets.push_back({.direction = target.direction,
                               .data_loss = data_loss(target, interval_s),
                               .seen = seen_target(target)});
    losses += quality.targets.back().data_loss;
  }
  quality.data_loss = losses / static_cast<double>(watched.size());
  quality.figures = figures_of(quality.targets);
  return quality;
}

bool passes(const GazeQuality& quality, const GazeGate& gate) {
  const bool all_seen = std::ranges::all_of(
      quality.targets, [](const TargetQuality& target) { return target.seen.has_value(); });
  return all_seen && quality.figures && quality.figures->accuracy_deg <= gate.max_accuracy_deg &&
         quality.figures->precision_rms_deg <= gate.max_precision_deg &&
         quality.data_loss <= gate.max_data_loss;
}

void InterSampleIntervals::add(const GazeSample& sample) {
  if (last_time_ && sample.time <= *last_time_) {
    return;
  }
  ++samples_;
  valid_samples_ += sample.valid ? 1 : 0;
  if (last_time_) {
    constexpr double gap_intervals = 1.5;
    const double interval_s = seconds(sample.time - *last_time_);
    const std::optional<double> default_s = median_interval_s();
    gaps_ += default_s && interval_s > gap_intervals * *default_s ? 1 : 0;
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
  const std::optional<double> default_s = median_interval_s();
  if (!default_s) {
    return std::nullopt;
  }
  double sum_s = 0.0;
  for (const double interval_s : intervals_s_) {
    sum_s += std::abs(interval_s - *default_s);
  }
  constexpr double ms_per_s = 1e3;
  return ms_per_s * sum_s / static_cast<double>(intervals_s_.size());
}

std::optional<double> InterSampleIntervals::median_interval_s() const {
  return upper_median({intervals_s_.begin(), intervals_s_.end()});
}

}  // namespace foveola
