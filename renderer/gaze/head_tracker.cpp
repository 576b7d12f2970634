#include "renderer/gaze/head_tracker.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "renderer/base/error.h"

namespace foveola {
namespace {

/// A stick's demand, rightwards and downwards, as a share of full speed: at most 1 long.
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

HeadPose head_pose(Nanoseconds time, const Quat& orientation) {
  constexpr double half_turn = 32768.0;
  constexpr double step_rad = std::numbers::pi / half_turn;
  const double steps = std::round(roll_of(orientation) / step_rad);
  return {.time = time,
          .heading = azimuth_elevation(orientation * Vec3(0.0F, 0.0F, -1.0F)),
          .roll_rad = step_rad * (steps < half_turn ? steps : -half_turn)};
}

ScriptedHeadTracker::ScriptedHeadTracker(std::vector<HeadPose> poses) : poses_(std::move(poses)) {
  const auto earlier = [](const HeadPose& a, const HeadPose& b) { return a.time < b.time; };
  if (poses_.empty() || std::ranges::adjacent_find(poses_, std::not_fn(earlier)) != poses_.end()) {
    throw Error("head poses", "no poses are given, or their times do not ascend",
                "give at least one pose, in the order of time");
  }
}

HeadPose ScriptedHeadTracker::pose(Nanoseconds now) {
  const auto next = std::upper_bound(
      poses_.begin(), poses_.end(), now,
      [](Nanoseconds time, const HeadPose& candidate) { return time < candidate.time; });
  if (next == poses_.begin() || next == poses_.end()) {
    const HeadPose& still = next == poses_.begin() ? poses_.front() : poses_.back();
    return {.time = now, .heading = still.heading, .roll_rad = still.roll_rad};
  }
  const HeadPose& from = *std::prev(next);
  const double done = seconds(now - from.time) / seconds(next->time - from.time);
  const double turn_rad = wrapped_angle(next->heading.azimuth_rad - from.heading.azimuth_rad);
  const double tilt_rad = wrapped_angle(next->roll_rad - from.roll_rad);
  return {.time = now,
          .heading = {.azimuth_rad = wrapped_angle(from.heading.azimuth_rad + done * turn_rad),
                      .elevation_rad =
                          std::lerp(from.heading.elevation_rad, next->heading.elevation_rad, done)},
          .roll_rad = wrapped_angle(from.roll_rad + done * tilt_rad)};
}

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
