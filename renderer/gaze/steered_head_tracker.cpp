#include "renderer/gaze/steered_head_tracker.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace foveola {
namespace {

/// What a stick asks for, rightwards and downwards, as a part of full speed: at most 1 long.
DVec2 part_asked_for(const DVec2& stick, const StickResponse& response) {
  const double push = glm::length(stick);
  const double travel = (push - response.dead_zone) / (response.full_push - response.dead_zone);
  if (!(travel > 0.0)) {
    return DVec2(0.0);
  }
  return std::pow(std::min(travel, 1.0), response.exponent) / push * stick;
}

constexpr double zenith_rad = 0.5 * std::numbers::pi;

AzimuthElevation turned(const AzimuthElevation& heading, const Turn& turn) {
  return {
      .azimuth_rad = wrapped_angle(heading.azimuth_rad + turn.right_rad),
      .elevation_rad = std::clamp(heading.elevation_rad + turn.up_rad, -zenith_rad, zenith_rad)};
}

}  // namespace

SteeredHeadTracker::SteeredHeadTracker(const AzimuthElevation& start) : heading_(start) {
  assert(std::abs(start.elevation_rad) <= zenith_rad);
}

void SteeredHeadTracker::turn(Nanoseconds time, const Turn& turn) {
  const std::lock_guard lock(mutex_);
  go_on_to(time);
  heading_ = turned(heading_, turn);
}

void SteeredHeadTracker::set_speed(Nanoseconds time, const TurnSpeed& speed) {
  const std::lock_guard lock(mutex_);
  go_on_to(time);
  speed_ = speed;
}

HeadPose SteeredHeadTracker::pose(Nanoseconds now) {
  const std::lock_guard lock(mutex_);
  return {.time = now, .heading = heading_at(now)};
}

AzimuthElevation SteeredHeadTracker::heading_at(Nanoseconds time) const {
  const double turning_s = std::max(0.0, seconds(time - since_));
  return turned(heading_, {.right_rad = speed_.right_rad_per_s * turning_s,
                           .up_rad = speed_.up_rad_per_s * turning_s});
}

void SteeredHeadTracker::go_on_to(Nanoseconds time) {
  heading_ = heading_at(time);
  since_ = std::max(since_, time);
}

TurnSpeed turn_speed(const GamepadSticks& sticks, const StickResponse& response) {
  assert(response.dead_zone >= 0.0 && response.dead_zone < response.full_push);
  const DVec2 asked =
      part_asked_for(sticks.left, response) + part_asked_for(sticks.right, response);
  const DVec2 part = asked / std::max(1.0, glm::length(asked));
  return {.right_rad_per_s = response.full_speed_rad_per_s * part.x,
          .up_rad_per_s = -response.full_speed_rad_per_s * part.y};
}

}  // namespace foveola
