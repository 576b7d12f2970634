#include <gtest/gtest.h>

#include "renderer/view/viewport.h"
#include "renderer/window/mouse_drags.h"

namespace foveola {
namespace {

/// Where a point lies in the axes of a camera's head.
Vec3 in_head(const Standing& camera, const Vec3& point) {
  return glm::conjugate(head_orientation(camera.heading)) * (point - camera.position);
}

TEST(CameraMovesTest, AnOrbitKeepsItsPivotInPlace) {
  const Standing before{.position = {1.0F, 2.0F, 5.0F}, .heading = {radians(10.0), radians(-5.0)}};
  const Vec3 pivot(0.5F, 1.0F, -1.0F);
  const Standing after =
      orbited(before, pivot, {.right_rad = radians(70.0), .up_rad = radians(-30.0)});
  EXPECT_NEAR(degrees(after.heading.azimuth_rad), 80.0, 1e-9);
  EXPECT_NEAR(degrees(after.heading.elevation_rad), -35.0, 1e-9);
  EXPECT_NEAR(glm::length(in_head(after, pivot) - in_head(before, pivot)), 0.0, 1e-5);
  EXPECT_GT(glm::length(after.position - before.position), 1.0F);
}

TEST(CameraMovesTest, AQuarterRoundWhatIsAhead) {
  const Standing after =
      orbited({.position = {0.0F, 0.0F, 2.0F}}, Vec3(0.0F), {.right_rad = radians(90.0)});
  // Looking towards +X from the left of it.
  EXPECT_NEAR(glm::length(after.position - Vec3(-2.0F, 0.0F, 0.0F)), 0.0, 1e-6);
}

TEST(CameraMovesTest, AnOrbitStopsOverhead) {
  const Standing after =
      orbited({.position = {0.0F, 0.0F, 2.0F}}, Vec3(0.0F), {.up_rad = radians(-200.0)});
  EXPECT_NEAR(degrees(after.heading.elevation_rad), -90.0, 1e-9);
  EXPECT_NEAR(glm::length(after.position - Vec3(0.0F, 2.0F, 0.0F)), 0.0, 1e-5);
}

TEST(CameraMovesTest, SpeedFitsTheSpace) {
  EXPECT_NEAR(walking_speed(5.0), 0.5, 1e-9);
  EXPECT_EQ(walking_speed(0.0), 1.0);
}

}  // namespace
}  // namespace foveola
