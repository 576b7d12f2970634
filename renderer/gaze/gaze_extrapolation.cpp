#include "renderer/gaze/gaze_extrapolation.h"

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/gaze/rotations.h"

namespace foveola {
namespace {

constexpr Nanoseconds longest_to_fit = std::chrono::milliseconds(100);
constexpr Nanoseconds shortest_to_fit = std::chrono::milliseconds(40);
constexpr std::size_t fewest_to_fit = 5;
/// In standard errors: what is no faster may be noise.
constexpr double doubted_velocity = 4.0;
constexpr double largest_turn_rad = radians(2.0);

/// A steady angular velocity.
struct Fit {
  DVec3 velocity_rad_s{0.0};
  double noise_rad2_s2 = 0.0;  ///< the mean square of the velocity if all were noise
};

/// From the newest sample's time and direction to those of another one.
struct Way {
  double time_s = 0.0;
  DVec3 turn_rad{0.0};
};

std::vector<Way> ways_to(std::span<const GazeSample> samples) {
  const GazeSample& newest = samples.back();
  const DVec3 from = glm::normalize(DVec3(newest.direction));
  std::vector<Way> ways;
  for (const GazeSample& sample : samples) {
    ways.push_back({.time_s = seconds(sample.time - newest.time),
                    .turn_rad = rotation_between(from, glm::normalize(DVec3(sample.direction)))});
  }
  return ways;
}

/// The least-squares line through turns over time. samples: at least 3, at different times.
Fit fit(std::span<const GazeSample> samples) {
  const auto count = static_cast<double>(samples.size());
  std::vector<Way> ways = ways_to(samples);
  Way mean;
  for (const Way& way : ways) {
    mean.time_s += way.time_s / count;
    mean.turn_rad += way.turn_rad / count;
  }
  double spread_s2 = 0.0;
  DVec3 covariance_rad_s(0.0);
  for (Way& way : ways) {
    way = {.time_s = way.time_s - mean.time_s, .turn_rad = way.turn_rad - mean.turn_rad};
    spread_s2 += way.time_s * way.time_s;
    covariance_rad_s += way.time_s * way.turn_rad;
  }
  const DVec3 velocity_rad_s = covariance_rad_s / spread_s2;
  double scatter_rad2 = 0.0;
  for (const Way& way : ways) {
    const DVec3 residual_rad = way.turn_rad - velocity_rad_s * way.time_s;
    scatter_rad2 += glm::dot(residual_rad, residual_rad);
  }
  return {.velocity_rad_s = velocity_rad_s,
          .noise_rad2_s2 = scatter_rad2 / ((count - 2.0) * spread_s2)};
}

/// What is believed of the velocity that was fitted.
DVec3 shrunk(const Fit& fit) {
  const double doubted = doubted_velocity * doubted_velocity * fit.noise_rad2_s2;
  const double square = glm::dot(fit.velocity_rad_s, fit.velocity_rad_s);
  return square > doubted ? fit.velocity_rad_s * (1.0 - doubted / square) : DVec3(0.0);
}

DVec3 limited(const DVec3& turn_rad) {
  const double angle_rad = glm::length(turn_rad);
  return angle_rad > largest_turn_rad ? turn_rad * (largest_turn_rad / angle_rad) : turn_rad;
}

bool suffice(std::span<const GazeSample> samples) {
  return samples.size() >= fewest_to_fit &&
         samples.back().time - samples.front().time >= shortest_to_fit;
}

}  // namespace

GazeExtrapolation::GazeExtrapolation(Nanoseconds horizon) : horizon_(horizon) {
  assert(horizon > Nanoseconds::zero() && horizon <= longest_horizon);
}

Vec3 GazeExtrapolation::extrapolated(const GazeSample& sample) {
  if (last_time_ && sample.time < *last_time_) {
    *this = GazeExtrapolation(horizon_);
  }
  last_time_ = sample.time;
  detector_.push(sample);
  if (!sample.valid) {
    return sample.direction;
  }
  if (detector_.now() != EyeMovementKind::fixation) {
    steady_.clear();
  }
  if (steady_.empty() || sample.time > steady_.back().time) {
    std::erase_if(steady_,
                  [&](const GazeSample& seen) { return sample.time - seen.time > longest_to_fit; });
    steady_.push_back(sample);
  }
  if (!suffice(steady_)) {
    return sample.direction;
  }
  const DVec3 turn_rad = limited(shrunk(fit(steady_)) * seconds(horizon_));
  return turn_rad == DVec3(0.0) ? sample.direction
                                : Vec3(glm::normalize(rotated(DVec3(sample.direction), turn_rad)));
}

}  // namespace foveola
