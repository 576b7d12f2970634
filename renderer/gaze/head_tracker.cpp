#include "renderer/gaze/head_tracker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/error.h"

namespace foveola {

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
  if (poses_.empty() ||
      std::adjacent_find(poses_.begin(), poses_.end(), std::not_fn(earlier)) != poses_.end()) {
    throw Error("head poses", "there are none, or their times do not ascend",
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

}  // namespace foveola
