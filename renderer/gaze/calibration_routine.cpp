#include "renderer/gaze/calibration_routine.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "renderer/base/angles.h"

namespace foveola {
namespace {

/// How far targets reach on the image plane at distance 1.
double reach(double fov_deg) {
  constexpr double part_of_view = 0.8;
  constexpr double farthest_deg = 20.0;
  return std::min(part_of_view * std::tan(radians(0.5 * fov_deg)), std::tan(radians(farthest_deg)));
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

}  // namespace foveola
