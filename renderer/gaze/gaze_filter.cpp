#include "renderer/gaze/gaze_filter.h"

#include <cassert>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

#include "renderer/base/angles.h"
#include "renderer/base/transformed.h"
#include "renderer/gaze/rotations.h"

namespace foveola {
namespace {

constexpr Nanoseconds longest_to_fit = std::chrono::milliseconds(100);
constexpr Nanoseconds shortest_to_fit = std::chrono::milliseconds(40);
constexpr std::size_t min_to_fit = 5;
/// In standard errors: slower velocities may be noise.
constexpr double doubted_velocity = 4.0;
constexpr double largest_turn_rad = radians(2.0);

/// A steady angular velocity.
struct Fit {
  DVec3 velocity_rad_s{0.0};
  double noise_rad2_s2 = 0.0;  ///< mean square of the velocity due to noise alone
};

/// From the newest sample's time and direction to another one's.
struct Way {
  double time_s = 0.0;
  DVec3 turn_rad{0.0};
};

std::vector<Way> ways_to(std::span<const GazeSample> samples) {
  const GazeSample& newest = samples.back();
  const DVec3 from = glm::normalize(DVec3(newest.direction));
  return transformed(samples, [&](const GazeSample& sample) {
    return Way{.time_s = seconds(sample.time - newest.time),
               .turn_rad = rotation_between(from, glm::normalize(DVec3(sample.direction)))};
  });
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

/// The fitted velocity after shrinkage.
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
  return samples.size() >= min_to_fit &&
         samples.back().time - samples.front().time >= shortest_to_fit;
}

/// Weight of a new value in an exponential low pass, `interval_s` after the last (algorithm 2).
double smoothing_factor(double cutoff_hz, double interval_s) {
  const double time_constant_s = 1.0 / (2.0 * std::numbers::pi * cutoff_hz);
  return 1.0 / (1.0 + time_constant_s / interval_s);
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

OneEuro::OneEuro(const OneEuroSettings& settings) : settings_(settings) {
  assert(settings.min_cutoff_hz > 0.0 && settings.derivative_cutoff_hz > 0.0);
  assert(settings.beta_per_deg >= 0.0);
}

Vec3 OneEuro::smoothed(Nanoseconds time, const Vec3& direction) {
  const DVec3 seen = glm::normalize(DVec3(direction));
  if (!state_ || time < state_->time || time - state_->time > settings_.reset_after) {
    state_ = State{.time = time, .direction = seen};
  } else if (time > state_->time) {
    const double interval_s = seconds(time - state_->time);
    const DVec3 turn_rad = rotation_between(state_->direction, seen);
    const DVec3 velocity_deg_s = turn_rad * (degrees(1.0) / interval_s);
    state_->velocity_deg_s = glm::mix(state_->velocity_deg_s, velocity_deg_s,
                                      smoothing_factor(settings_.derivative_cutoff_hz, interval_s));
    const double cutoff_hz =
        settings_.min_cutoff_hz + settings_.beta_per_deg * glm::length(state_->velocity_deg_s);
    state_->direction = glm::normalize(
        rotated(state_->direction, turn_rad * smoothing_factor(cutoff_hz, interval_s)));
    state_->time = time;
  }
  return Vec3(state_->direction);
}

GazeHold::GazeHold(Nanoseconds limit) : limit_(limit) {
  assert(limit > Nanoseconds::zero() && limit <= longest_hold);
}

std::vector<GazeSample> GazeHold::passed(Nanoseconds now, const std::vector<GazeSample>& arrived) {
  std::vector<GazeSample> passed;
  for (const GazeSample& sample : arrived) {
    if (sample.valid) {
      held_ = sample.time;
    }
    const bool is_kept_back = !sample.valid && held_ && now - *held_ <= limit_;
    if (!is_kept_back) {
      passed.push_back(sample);
    }
  }
  if (held_ && now - *held_ > limit_) {
    held_.reset();
    if (arrived.empty() || arrived.back().valid) {
      passed.push_back({.time = now});
    }
  }
  return passed;
}

GazeFilter::GazeFilter(const GazeFilterSettings& settings) {
  if (settings.one_euro) {
    one_euro_.emplace(*settings.one_euro);
  }
  if (settings.extrapolate_s) {
    extrapolation_.emplace(nanoseconds_from_seconds(*settings.extrapolate_s));
  }
  if (settings.hold_s) {
    hold_.emplace(nanoseconds_from_seconds(*settings.hold_s));
  }
}

std::vector<GazeSample> GazeFilter::filtered(Nanoseconds now, std::vector<GazeSample> arrived) {
  for (GazeSample& sample : arrived) {
    if (one_euro_ && sample.valid) {
      sample.direction = one_euro_->smoothed(sample.time, sample.direction);
    }
    if (extrapolation_) {
      sample.direction = extrapolation_->extrapolated(sample);
    }
  }
  return hold_ ? hold_->passed(now, arrived) : std::move(arrived);
}

}  // namespace foveola
