// Gaze samples as tests of eye trackers make and expect them.
#pragma once

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

namespace test {

inline Vec3 at_deg(double azimuth_deg, double elevation_deg = 0.0) {
  return direction_from(
      {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)});
}

inline GazeSample seen_at(int time_ms, double azimuth_deg) {
  return {
      .time = std::chrono::milliseconds(time_ms), .direction = at_deg(azimuth_deg), .valid = true};
}

inline GazeSample lost_at(int time_ms) { return {.time = std::chrono::milliseconds(time_ms)}; }

}  // namespace test

/// That `direction` is the unit vector along `expected`.
inline void expect_along(const Vec3& direction, const Vec3& expected) {
  EXPECT_LT(glm::distance(direction, glm::normalize(expected)), 1e-6F);
}

/// The last sample, if there is one.
inline std::optional<GazeSample> newest(const std::vector<GazeSample>& samples) {
  return samples.empty() ? std::nullopt : std::optional(samples.back());
}

}  // namespace foveola
