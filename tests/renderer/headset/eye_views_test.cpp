#include "renderer/headset/eye_views.h"

#include <cmath>

#include <gtest/gtest.h>

namespace foveola {
namespace {

constexpr XrFovf fov_deg(double left, double right, double up, double down) {
  return {static_cast<float>(radians(left)), static_cast<float>(radians(right)),
          static_cast<float>(radians(up)), static_cast<float>(radians(down))};
}

XrView eye(const XrFovf& fov, const Quat& orientation = {1.0F, 0.0F, 0.0F, 0.0F}) {
  return {XR_TYPE_VIEW,
          nullptr,
          {{orientation.x, orientation.y, orientation.z, orientation.w}, {0.0F, 0.0F, 0.0F}},
          fov};
}

Vec3 in_degrees(double right_deg, double up_deg) {
  return glm::normalize(Vec3(std::tan(radians(right_deg)), std::tan(radians(up_deg)), -1.0));
}

void expect_same(const Vec3& a, const Vec3& b) { EXPECT_LT(degrees(angle_between(a, b)), 1e-3); }

TEST(EyeViews, ReachAsFarToEachSideAsTheRuntimeSays) {
  const Viewport view = viewport_of(eye(fov_deg(-52, 40, 45, -48)), {1.0F, 0.0F, 0.0F, 0.0F});
  expect_same(view.direction({0.0F, 0.0F}), in_degrees(-52, 45));
  expect_same(view.direction({1.0F, 0.0F}), in_degrees(40, 45));
  expect_same(view.direction({0.0F, 1.0F}), in_degrees(-52, -48));
  expect_same(view.direction({1.0F, 1.0F}), in_degrees(40, -48));
}

TEST(EyeViews, AreTurnedAsTheEyeAndTheRoom) {
  const Quat outwards = head_orientation({.azimuth_rad = radians(-10.0)});
  const Quat room = head_orientation({.azimuth_rad = radians(90.0)});
  const Viewport view = viewport_of(eye(fov_deg(-45, 45, 45, -45), outwards), room);
  expect_same(view.direction({0.5F, 0.5F}), direction_from({.azimuth_rad = radians(80.0)}));
}

TEST(EyeViews, OfBothEyesHoldEach) {
  const FieldOfView both = field_of_view_of_both(
      {eye(fov_deg(-52, 40, 45, -48)), eye(fov_deg(-40, 53, 44, -49))}, {1.0F, 0.0F, 0.0F, 0.0F});
  const Viewport view = viewport_of(Quat(1.0F, 0.0F, 0.0F, 0.0F), both);
  expect_same(view.direction({0.0F, 0.0F}), in_degrees(-52, 45));
  expect_same(view.direction({1.0F, 1.0F}), in_degrees(53, -49));
}

// A canted view's corners reach farther up than its sides' middles.
TEST(EyeViews, OfBothEyesHoldEachCornerOfOnesThatPointOutwards) {
  const Quat head = head_orientation({.azimuth_rad = 1.0, .elevation_rad = 0.3}, 0.2);
  std::array<XrView, 2> eyes;
  for (int i = 0; i < 2; ++i) {
    const double cant_rad = radians(i == 0 ? -15.0 : 15.0);
    eyes[i] = eye(fov_deg(-45, 45, 45, -45), head * head_orientation({.azimuth_rad = cant_rad}));
  }
  const Viewport both = viewport_of(head, field_of_view_of_both(eyes, head));
  bool touches_top = false;
  for (const XrView& one : eyes) {
    const Viewport view = viewport_of(one, {1.0F, 0.0F, 0.0F, 0.0F});
    for (const Vec2& corner : {Vec2(1e-3F), Vec2(0.999F, 1e-3F), Vec2(1e-3F, 0.999F)}) {
      const std::optional<Vec2> place = both.project(view.direction(corner));
      ASSERT_TRUE(place);
      touches_top = touches_top || place->y < 2e-3F;
    }
  }
  EXPECT_TRUE(touches_top) << "it is larger than it has to be";
}

TEST(EyeViews, OfBothEyesReachAtMost80DegreesToEachSide) {
  const FieldOfView both = field_of_view_of_both(
      {eye(fov_deg(-60, 60, 50, -50), head_orientation({.azimuth_rad = radians(-40.0)})),
       eye(fov_deg(-60, 60, 50, -50), head_orientation({.azimuth_rad = radians(40.0)}))},
      {1.0F, 0.0F, 0.0F, 0.0F});
  EXPECT_NEAR(both.horizontal_deg, 160.0, 1e-3);
}

}  // namespace
}  // namespace foveola
