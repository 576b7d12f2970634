#include "renderer/window/widened_eye_tracker.h"

#include <gtest/gtest.h>

#include "renderer/base/angles.h"

namespace foveola {
namespace {

Vec3 seen(const Vec3& direction, double times) {
  FixedEyeTracker fixed(direction);
  WidenedEyeTracker eye(fixed);
  eye.widen(times);
  std::vector<GazeSample> arrived = {{.direction = Vec3(1.0F, 0.0F, 0.0F), .valid = true}};
  eye.poll(Nanoseconds(1), arrived);
  EXPECT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived.front().direction, Vec3(1.0F, 0.0F, 0.0F)) << "it came before";
  return arrived.back().direction;
}

TEST(WidenedEyeTrackerTest, GoesFartherOnThePlaneBeforeTheEye) {
  const Vec3 widened = seen(glm::normalize(Vec3(0.1F, -0.2F, -1.0F)), 3.0);
  EXPECT_NEAR(glm::length(widened - glm::normalize(Vec3(0.3F, -0.6F, -1.0F))), 0.0, 1e-6);
}

TEST(WidenedEyeTrackerTest, LeavesTrueAnglesToTheBit) {
  const Vec3 direction = glm::normalize(Vec3(0.123F, -0.234F, -1.0F));
  EXPECT_EQ(seen(direction, 1.0), direction);
}

TEST(WidenedEyeTrackerTest, WhatLiesBehindStays) {
  const Vec3 direction = glm::normalize(Vec3(0.5F, 0.0F, 1.0F));
  EXPECT_EQ(seen(direction, 2.0), direction);
}

}  // namespace
}  // namespace foveola
