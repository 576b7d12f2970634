#include "renderer/progressive/picture.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace foveola {
namespace {

CameraView camera(std::optional<double> vertical_fov_deg, std::optional<double> aspect_ratio) {
  CameraView view;
  if (vertical_fov_deg) {
    view.vertical_fov_rad = radians(*vertical_fov_deg);
  }
  view.aspect_ratio = aspect_ratio;
  return view;
}

/// The tangent of half an angle.
double half_tangent(double fov_deg) { return std::tan(0.5 * radians(fov_deg)); }

TEST(Picture, WithoutACameraItSees60DegreesAlongTheLargerSide) {
  const Picture wide = picture_of(camera({}, {}), {});
  EXPECT_EQ(wide.size, IVec2(1280, 720));
  EXPECT_NEAR(wide.field_of_view.horizontal_deg, 60.0, 1e-9);
  EXPECT_NEAR(half_tangent(wide.field_of_view.vertical_deg), half_tangent(60.0) * 9.0 / 16.0, 1e-9);
  const Picture tall = picture_of(camera({}, {}), {.size = IVec2(300, 400)});
  EXPECT_NEAR(tall.field_of_view.vertical_deg, 60.0, 1e-9);
  EXPECT_NEAR(half_tangent(tall.field_of_view.horizontal_deg), half_tangent(60.0) * 0.75, 1e-9);
}

TEST(Picture, TakesTheCamerasFieldOfViewAndAspectRatio) {
  const Picture square = picture_of(camera(50.0, 1.0), {});
  EXPECT_EQ(square.size, IVec2(720, 720));
  EXPECT_NEAR(square.field_of_view.vertical_deg, 50.0, 1e-9);
  EXPECT_NEAR(square.field_of_view.horizontal_deg, 50.0, 1e-9);
  EXPECT_EQ(picture_of(camera(50.0, 2.0), {}).size, IVec2(1280, 640));
  EXPECT_EQ(picture_of(camera(50.0, 0.5), {}).size, IVec2(360, 720));
  EXPECT_EQ(picture_of(camera(50.0, 1e9), {}).size, IVec2(1280, 1));
}

TEST(Picture, OtherSizesKeepTheHeightThatTheCameraSees) {
  const Picture picture = picture_of(camera(40.0, 1.0), {.size = IVec2(200, 100)});
  EXPECT_EQ(picture.size, IVec2(200, 100));
  EXPECT_NEAR(picture.field_of_view.vertical_deg, 40.0, 1e-9);
  EXPECT_NEAR(half_tangent(picture.field_of_view.horizontal_deg), 2.0 * half_tangent(40.0), 1e-9);
}

TEST(Picture, TheUsersFieldOfViewComesFirst) {
  const Picture width =
      picture_of(camera(40.0, 1.0), {.size = IVec2(200, 100), .horizontal_fov_deg = 90.0});
  EXPECT_EQ(width.field_of_view.horizontal_deg, 90.0);
  EXPECT_NEAR(half_tangent(width.field_of_view.vertical_deg), 0.5, 1e-9);
  const Picture both =
      picture_of(camera(40.0, 1.0), {.horizontal_fov_deg = 90.0, .vertical_fov_deg = 20.0});
  EXPECT_EQ(both.field_of_view.vertical_deg, 20.0);
}

/// The angle between the directions through the middles of two neighbouring pixels.
TEST(Picture, ItsPixelAngleIsThatOfItsMiddle) {
  const Picture picture = picture_of(camera(40.0, {}), {.size = IVec2(101, 51)});
  const Viewport view = viewport_of(camera({}, {}), picture.field_of_view);
  const double between =
      angle_between(view.direction({50.5F / 101.0F, 0.5F}), view.direction({51.5F / 101.0F, 0.5F}));
  EXPECT_NEAR(pixel_angle_rad(picture), between, 1e-4 * between);
}

/// A camera that is turned clockwise has what was above it to the left of its picture's top.
TEST(Picture, ARolledCameraTurnsThePicture) {
  CameraView view;
  view.roll_rad = 0.5 * std::numbers::pi;
  const FieldOfView fov{.horizontal_deg = 90.0, .vertical_deg = 90.0, .lens = {}};
  const Vec3 up_left = glm::normalize(Vec3(0.0F, 0.5F, -1.0F));
  const std::optional<Vec2> plane = viewport_of(view, fov).project(up_left);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->x, 0.25F, 1e-5F);
  EXPECT_NEAR(plane->y, 0.5F, 1e-5F);
}

}  // namespace
}  // namespace foveola
