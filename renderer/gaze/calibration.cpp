#include "renderer/gaze/calibration.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "renderer/base/angles.h"

namespace foveola {
namespace {

/// Targets' maximum distance from the centre, on the image plane at distance 1.
double reach(double fov_deg) {
  constexpr double part_of_view = 0.8;
  constexpr double farthest_deg = 20.0;
  return std::min(part_of_view * std::tan(radians(0.5 * fov_deg)), std::tan(radians(farthest_deg)));
}

/// Azimuth and elevation.
DVec2 angles_deg(const Vec3& direction) {
  const AzimuthElevation angles = azimuth_elevation(direction);
  return {degrees(angles.azimuth_rad), degrees(angles.elevation_rad)};
}

/// The factors of a correction's row: 1, azimuth and elevation.
DVec3 weighed(const Vec3& seen) {
  const DVec2 angles = angles_deg(seen);
  return {1.0, angles.x, angles.y};
}

/// The smallest variance of `points` along any direction; 0 without points.
double smallest_variance(const std::vector<DVec2>& points) {
  const auto count = static_cast<double>(std::max<std::size_t>(points.size(), 1));
  DVec2 mean(0.0);
  for (const DVec2& point : points) {
    mean += point / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const DVec2& point : points) {
    const DVec2 offset = point - mean;
    xx += offset.x * offset.x / count;
    xy += offset.x * offset.y / count;
    yy += offset.y * offset.y / count;
  }
  // The smaller eigenvalue of their covariance matrix.
  return 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
}

}  // namespace

std::vector<Vec3> calibration_targets(int points, double horizontal_fov_deg,
                                      double vertical_fov_deg) {
  assert(points == 5 || points == 9);
  const double right = reach(horizontal_fov_deg);
  const double up = reach(vertical_fov_deg);
  std::vector<Vec3> targets{{0.0F, 0.0F, -1.0F}};
  for (const int row : {1, 0, -1}) {
    for (const int column : {-1, 0, 1}) {
      const bool is_middle = row == 0 && column == 0;
      const bool is_corner = row != 0 && column != 0;
      if (is_corner || (points == 9 && !is_middle)) {
        targets.emplace_back(glm::normalize(DVec3(column * right, row * up, -1.0)));
      }
    }
  }
  return targets;
}

CalibrationRoutine::CalibrationRoutine(std::vector<Vec3> targets, const CalibrationTiming& timing,
                                       Nanoseconds start)
    : targets_(std::move(targets)), timing_(timing) {
  assert(!targets_.empty() && timing_.give_up > timing_.settle);
  show_next(start);
}

void CalibrationRoutine::update(Nanoseconds now, std::span<const GazeSample> arrived) {
  for (const GazeSample& sample : arrived) {
    if (!target()) {
      return;
    }
    if (sample.time >= watching_.start && collect(sample)) {
      watching_.end = sample.time;
      watched_.push_back(std::move(watching_));
      show_next(now);
    }
  }
  const Nanoseconds limit = watching_.start - timing_.settle + timing_.give_up;
  if (target() && now >= limit) {
    watching_.end = limit;
    watched_.push_back(std::move(watching_));
    show_next(now);
  }
}

std::optional<Vec3> CalibrationRoutine::target() const {
  return watched_.size() < targets_.size() ? std::optional(targets_[watched_.size()])
                                           : std::nullopt;
}

bool CalibrationRoutine::collect(const GazeSample& sample) {
  watching_.samples.push_back(sample);
  if (sample.valid) {
    const Nanoseconds interval = sample.time - last_valid_.value_or(sample.time);
    if (interval <= timing_.longest_interval) {
      collected_ += std::max(interval, Nanoseconds::zero());
    }
    last_valid_ = sample.time;
  }
  return collected_ >= timing_.collect;
}

void CalibrationRoutine::show_next(Nanoseconds now) {
  watching_ = {};
  collected_ = Nanoseconds::zero();
  last_valid_.reset();
  if (const std::optional<Vec3> next = target()) {
    watching_.direction = *next;
    watching_.start = now + timing_.settle;
  }
}

Vec3 corrected(const Vec3& direction, const GazeCorrection& correction) {
  const DVec3 seen = weighed(direction);
  return direction_from({.azimuth_rad = radians(glm::dot(correction.azimuth, seen)),
                         .elevation_rad = radians(glm::dot(correction.elevation, seen))});
}

GazeCorrection combined(const GazeCorrection& first, const GazeCorrection& second) {
  const auto row = [&](const DVec3& of_second) {
    return DVec3(of_second.x, 0.0, 0.0) + of_second.y * first.azimuth +
           of_second.z * first.elevation;
  };
  return {.azimuth = row(second.azimuth), .elevation = row(second.elevation)};
}

std::optional<GazeCorrection> fit_correction(std::span<const TargetQuality> targets) {
  constexpr double least_deviation_deg = 1.0;
  std::vector<DVec2> gazes_deg;
  DMat3 normal(0.0);
  DVec3 of_azimuth(0.0);
  DVec3 of_elevation(0.0);
  for (const TargetQuality& target : targets) {
    if (target.seen) {
      const DVec3 seen = weighed(target.seen->mean_gaze);
      const DVec2 wanted_deg = angles_deg(target.direction);
      gazes_deg.emplace_back(seen.y, seen.z);
      normal += glm::outerProduct(seen, seen);
      of_azimuth += seen * wanted_deg.x;
      of_elevation += seen * wanted_deg.y;
    }
  }
  if (smallest_variance(gazes_deg) < least_deviation_deg * least_deviation_deg) {
    return std::nullopt;
  }
  const DMat3 inverse = glm::inverse(normal);
  return GazeCorrection{.azimuth = inverse * of_azimuth, .elevation = inverse * of_elevation};
}

void correct(std::span<GazeSample> samples, const GazeCorrection& correction) {
  for (GazeSample& sample : samples) {
    if (sample.valid) {
      sample.direction = corrected(sample.direction, correction);
    }
  }
}

CorrectedEyeTracker::CorrectedEyeTracker(std::unique_ptr<EyeTracker> source,
                                         const GazeCorrection& correction)
    : source_(std::move(source)), correction_(correction) {}

void CorrectedEyeTracker::add(const GazeCorrection& correction) {
  correction_ = combined(correction_, correction);
}

void CorrectedEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const std::size_t before = arrived.size();
  source_->poll(now, arrived);
  if (correction_ != GazeCorrection{}) {
    correct(std::span(arrived).subspan(before), correction_);
  }
}

GazeCheck check_gaze(std::span<const WatchedTarget> watched, bool corrects,
                     CorrectedEyeTracker& tracker) {
  GazeCheck check{.quality = gaze_quality(watched), .correction = std::nullopt};
  if (corrects) {
    check.correction = fit_correction(check.quality.targets);
  }
  if (check.correction) {
    tracker.add(*check.correction);
  }
  return check;
}

}  // namespace foveola
