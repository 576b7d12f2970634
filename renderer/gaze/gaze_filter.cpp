#include "renderer/gaze/gaze_filter.h"

#include <cassert>
#include <cstddef>
#include <numbers>
#include <span>
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

HoldFilter::HoldFilter(std::unique_ptr<EyeTracker> source, Nanoseconds limit)
    : source_(std::move(source)), limit_(limit) {
  assert(limit > Nanoseconds::zero() && limit <= longest_hold);
}

void HoldFilter::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  polled_.clear();
  source_->poll(now, polled_);
  for (const GazeSample& sample : polled_) {
    if (sample.valid) {
      held_ = sample.time;
    }
    const bool is_kept_back = !sample.valid && held_ && now - *held_ <= limit_;
    if (!is_kept_back) {
      arrived.push_back(sample);
    }
  }
  if (held_ && now - *held_ > limit_) {
    held_.reset();
    if (polled_.empty() || polled_.back().valid) {
      arrived.push_back({.time = now});
    }
  }
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

OneEuroFilter::OneEuroFilter(std::unique_ptr<EyeTracker> source, const OneEuroSettings& settings)
    : source_(std::move(source)), filter_(settings) {}

void OneEuroFilter::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const std::size_t before = arrived.size();
  source_->poll(now, arrived);
  for (GazeSample& sample : std::span(arrived).subspan(before)) {
    if (sample.valid) {
      sample.direction = filter_.smoothed(sample.time, sample.direction);
    }
  }
}

std::unique_ptr<EyeTracker> filtered(std::unique_ptr<EyeTracker> source,
                                     const GazeFilterSettings& settings) {
  if (settings.one_euro) {
    source = std::make_unique<OneEuroFilter>(std::move(source), *settings.one_euro);
  }
  if (settings.hold) {
    source = std::make_unique<HoldFilter>(std::move(source), *settings.hold);
  }
  return source;
}

}  // namespace foveola
