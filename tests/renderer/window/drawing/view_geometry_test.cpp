#include "renderer/window/drawing/view_geometry.h"

#include <cmath>

#include <gtest/gtest.h>

namespace foveola {
namespace {

DisplayProfile monitor() {
  return {.kind = DisplayKind::monitor,
          .width_px = 2000,
          .height_px = 1000,
          .refresh_rate_hz = 60.0,
          .width_m = 0.6,
          .height_m = 0.3,
          .viewing_distance_m = 0.5};
}

DisplayProfile headset() {
  return {.kind = DisplayKind::headset,
          .width_px = 2560,
          .height_px = 1440,
          .refresh_rate_hz = 70.0,
          .horizontal_fov_deg = 100.0,
          .vertical_fov_deg = 90.0,
          .lens = RadialLens{.axis = {0.55F, 0.5F}, .k1 = 0.2F, .k2 = 0.1F}};
}

TEST(ViewGeometryTest, AMonitorIsAPaneAtItsDistance) {
  const ViewGeometry full = view_geometry(monitor(), {2000, 1000});
  EXPECT_NEAR(full.horizontal_fov_deg, 61.928, 1e-3);  // 2 atan(0.3 / 0.5)
  EXPECT_NEAR(full.vertical_fov_deg, 33.398, 1e-3);    // 2 atan(0.15 / 0.5)
  const ViewGeometry window = view_geometry(monitor(), {500, 1000});
  EXPECT_NEAR(window.horizontal_fov_deg, 17.062, 1e-3);  // 2 atan(0.075 / 0.5)
  EXPECT_DOUBLE_EQ(window.vertical_fov_deg, full.vertical_fov_deg);
  ASSERT_EQ(window.parts.size(), 1U);
  EXPECT_EQ(window.parts[0].size, IVec2(500, 1000));
}

TEST(ViewGeometryTest, AMonitorShowsWhatIsAskedAcrossItsLargerSide) {
  const ViewGeometry wide = view_geometry(monitor(), {1000, 500}, 90.0);
  EXPECT_NEAR(wide.horizontal_fov_deg, 90.0, 1e-9);
  EXPECT_NEAR(wide.vertical_fov_deg, 53.130, 1e-3);  // 2 atan(0.5)
  EXPECT_NEAR(larger_fov_deg(wide), 90.0, 1e-9);
  const ViewGeometry high = view_geometry(monitor(), {500, 1000}, 90.0);
  EXPECT_NEAR(high.horizontal_fov_deg, 53.130, 1e-3);
  EXPECT_NEAR(high.vertical_fov_deg, 90.0, 1e-9);
  EXPECT_EQ(view_geometry(headset(), {1280, 720}, 60.0).horizontal_fov_deg, 100.0);
  // On this monitor 1000 pixels are 0.3 m, half a metre away.
  EXPECT_NEAR(widening(wide, view_geometry(monitor(), {1000, 500})), 0.5 / 0.15, 1e-9);
}

TEST(ViewGeometryTest, AHeadsetShowsItsWholeViewToEachEye) {
  const ViewGeometry geometry = view_geometry(headset(), {1281, 720});
  EXPECT_EQ(geometry.horizontal_fov_deg, 100.0);
  EXPECT_EQ(geometry.vertical_fov_deg, 90.0);
  ASSERT_EQ(geometry.parts.size(), 2U);
  EXPECT_EQ(geometry.parts[0].origin, IVec2(0, 0));
  EXPECT_EQ(geometry.parts[1].origin, IVec2(640, 0));
  EXPECT_EQ(geometry.parts[0].size, IVec2(640, 720));
  EXPECT_EQ(geometry.parts[1].size, IVec2(640, 720));
}

TEST(ViewGeometryTest, EyesLookThroughMirroredLenses) {
  const ViewGeometry geometry = view_geometry(headset(), {1280, 720});
  const std::vector<Viewport> eyes = viewports_of(geometry, head_orientation({}));
  ASSERT_EQ(eyes.size(), 2U);
  EXPECT_FLOAT_EQ(eyes[0].lens().axis.x, 0.55F);
  EXPECT_FLOAT_EQ(eyes[1].lens().axis.x, 0.45F);
  // What the left eye has at the left edge, the right eye has at the right one, mirrored.
  const Vec3 left = eyes[0].direction({0.1F, 0.3F});
  const Vec3 right = eyes[1].direction({0.9F, 0.3F});
  EXPECT_NEAR(left.x, -right.x, 1e-6);
  EXPECT_NEAR(left.y, right.y, 1e-6);
}

TEST(ViewGeometryTest, DirectionsBelowThePointer) {
  const ViewGeometry pane = view_geometry(monitor(), {2000, 1000});
  const Vec3 middle = direction_below(pane, {1000.0, 500.0}, 1000);
  EXPECT_NEAR(glm::length(middle - Vec3(0, 0, -1)), 0.0, 1e-6);
  // 0.3 m right of and 0.15 m above the middle, half a metre away.
  const Vec3 corner = direction_below(pane, {2000.0, 0.0}, 1000);
  EXPECT_NEAR(glm::length(corner - glm::normalize(Vec3(0.3F, 0.15F, -0.5F))), 0.0, 1e-6);
}

TEST(ViewGeometryTest, EachEyesHalfHasItsOwnDirections) {
  const ViewGeometry geometry = view_geometry(headset(), {1280, 720});
  const std::vector<Viewport> eyes = viewports_of(geometry, head_orientation({}));
  const Vec3 left = direction_below(geometry, {160.0, 180.0}, 720);
  EXPECT_NEAR(glm::length(left - eyes[0].direction({0.25F, 0.25F})), 0.0, 1e-6);
  const Vec3 right = direction_below(geometry, {640.0 + 160.0, 180.0}, 720);
  EXPECT_NEAR(glm::length(right - eyes[1].direction({0.25F, 0.25F})), 0.0, 1e-6);
}

}  // namespace
}  // namespace foveola
