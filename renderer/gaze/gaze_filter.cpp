#include "renderer/gaze/gaze_filter.h"

#include <cassert>
#include <numbers>
#include <utility>

#include "renderer/base/angles.h"
#include "renderer/gaze/rotations.h"

namespace foveola {
namespace {

/// The weight of a new value in an exponential low pass, `interval_s` after the last (algorithm 2).
double smoothing_factor(double cutoff_hz, double interval_s) {
  const double time_constant_s = 1.0 / (2.0 * std::numbers::pi * cutoff_hz);
  return 1.0 / (1.0 + time_constant_s / interval_s);
}

}  // namespace

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
