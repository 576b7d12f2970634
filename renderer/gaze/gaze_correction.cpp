#include "renderer/gaze/gaze_correction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "renderer/base/angles.h"

namespace foveola {
namespace {

/// Azimuth and elevation.
DVec2 angles_deg(const Vec3& direction) {
  const AzimuthElevation angles = azimuth_elevation(direction);
  return {degrees(angles.azimuth_rad), degrees(angles.elevation_rad)};
}

/// What a row of a correction multiplies: 1, azimuth and elevation.
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
