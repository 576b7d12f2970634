#include "renderer/progressive/picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/stability/shapes.h"

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

constexpr AzimuthElevation askew{.azimuth_rad = -0.5, .elevation_rad = -0.35};
const FieldOfView wide{.horizontal_deg = 60.0, .vertical_deg = 36.0, .lens = {}};

/// The part of the picture, each way, that the points take up around its middle; above 1 if some
/// are outside.
Vec2 extent_of(const std::vector<Vec3>& points, const Vec3& camera) {
  const Viewport view(askew, {.horizontal_deg = 120.0, .vertical_deg = 120.0, .lens = {}});
  const Vec2 scale(std::tan(radians(60.0)) / std::tan(radians(30.0)),
                   std::tan(radians(60.0)) / std::tan(radians(18.0)));
  Vec2 largest(0.0F);
  Vec2 smallest(1e9F);
  for (const Vec3& point : points) {
    const std::optional<Vec2> plane = view.project(glm::normalize(point - camera));
    if (!plane) {
      return Vec2(2.0F);
    }
    const Vec2 from_middle = scale * (2.0F * *plane - 1.0F);
    largest = glm::max(largest, from_middle);
    smallest = glm::min(smallest, from_middle);
  }
  EXPECT_NEAR(largest.x, -smallest.x, 0.2F) << "not in the middle";
  return glm::max(largest, -smallest);
}

TEST(Framing, FillsThePictureButForAMargin) {
  const std::vector<Vec3> points = {{-1, 0, -1}, {1, 0.2F, 1}, {1, 3, -1}, {-0.5F, 2, 1}};
  Framing framing(askew, wide);
  for (const Vec3& point : points) {
    framing.include(point);
  }
  const Vec2 extent = extent_of(points, framing.position());
  EXPECT_NEAR(std::max(extent.x, extent.y), 0.9F, 1e-3F);
}

TEST(Framing, OfAnObjectIsThatOfItsVerticesInTheWorld) {
  Scene scene;
  scene.materials = {matte(Rgb(0.5F))};
  scene.prototypes = {inward_box(Vec3(0.0F), 1.0F, 0)};
  scene.instances.resize(1);
  scene.instances[0].world_from_local[3] = Vec4(5.0F, 0.0F, 0.0F, 1.0F);
  Framing of_object(askew, wide);
  of_object.include(scene, 0);
  Framing of_bounds(askew, wide);
  of_bounds.include(Bounds{.lower = {4, -1, -1}, .upper = {6, 1, 1}});
  EXPECT_LT(glm::distance(of_object.position(), of_bounds.position()), 1e-5F);
}

TEST(Framing, ScalesWithWhatItIsOf) {
  const auto place = [](float size) {
    Framing framing(askew, wide);
    framing.include(Bounds{.lower = Vec3(-size), .upper = Vec3(size)});
    return framing.position();
  };
  EXPECT_LT(glm::distance(place(1e-3F), 1e-3F * place(1.0F)), 1e-8F);
  EXPECT_LT(glm::distance(place(1e6F), 1e6F * place(1.0F)), 1.0F);
}

}  // namespace

}  // namespace foveola
