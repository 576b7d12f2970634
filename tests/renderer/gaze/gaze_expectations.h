// What tests of eye trackers expect of gaze samples.
#pragma once

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/vec.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// That `direction` is the unit vector along `expected`.
inline void expect_along(const Vec3& direction, const Vec3& expected) {
  EXPECT_LT(glm::distance(direction, glm::normalize(expected)), 1e-6F);
}

/// The last sample, if there is one.
inline std::optional<GazeSample> newest(const std::vector<GazeSample>& samples) {
  return samples.empty() ? std::nullopt : std::optional(samples.back());
}

}  // namespace foveola
