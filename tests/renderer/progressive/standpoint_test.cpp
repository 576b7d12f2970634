#include "renderer/progressive/standpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/stability/shapes.h"

namespace foveola::test {
namespace {

using ::testing::HasSubstr;

Scene scene_of(std::vector<Mesh> meshes) {
  Scene scene;
  scene.meshes = std::move(meshes);
  scene.materials = {matte(Rgb(0.5F))};
  return scene;
}

Standpoint standpoint_in(const Scene& scene) {
  const Workers workers;
  return choose_standpoint(scene, RayScene(scene, workers));
}

Mesh outward_box(const Vec3& center, float half) { return inside_out(inward_box(center, half, 0)); }

void expect_near(const Vec3& actual, const Vec3& expected) {
  EXPECT_NEAR(glm::distance(actual, expected), 0.0F, 1e-5F * (1.0F + glm::length(expected)));
}

void expect_in_the_middle(const Scene& scene, const Vec3& middle) {
  const Standpoint stand = standpoint_in(scene);
  expect_near(stand.position, middle);
  EXPECT_EQ(stand.heading.azimuth_rad, 0.0);
  EXPECT_EQ(stand.heading.elevation_rad, 0.0);
  EXPECT_THAT(stand.reason, HasSubstr("the middle"));
}

/// The cube's corners are sqrt(3) m from its middle; a cone of 60 degrees holds that ball from
/// twice as far.
TEST(Standpoint, IsInFrontOfAClosedObject) {
  const Standpoint stand = standpoint_in(scene_of({outward_box({4, 5, 6}, 1.0F)}));
  expect_near(stand.position, {4, 5, 6 + 2.0F * std::sqrt(3.0F)});
  EXPECT_EQ(stand.heading.azimuth_rad, 0.0);
  EXPECT_EQ(stand.heading.elevation_rad, 0.0);
  EXPECT_THAT(stand.reason, HasSubstr("inside a closed object"));
}

/// In an instance that mirrors, the corners' order turns around, but not what is in front.
TEST(Standpoint, IsInFrontOfAMirroredInstanceToo) {
  Scene scene = scene_of({});
  scene.prototypes = {outward_box(Vec3(0.0F), 1.0F)};
  scene.instances.resize(1);
  scene.instances[0].world_from_local[0][0] = -1.0F;
  EXPECT_THAT(standpoint_in(scene).reason, HasSubstr("inside a closed object"));
  scene.prototypes = {inward_box(Vec3(0.0F), 1.0F, 0)};
  expect_in_the_middle(scene, Vec3(0.0F));
}

/// A sphere without its cap, as a head without its neck, with an eye in it.
TEST(Standpoint, IsInFrontOfAHead) {
  Mesh head = inside_out(inward_sphere(1.0F, 3, 0));
  std::erase_if(head.triangles,
                [&](const auto& corners) { return head.positions[corners[0]].y < -0.8F; });
  const Mesh eye =
      placed(outward_box(Vec3(0.0F), 0.1F), 1.0F, Quat(1, 0, 0, 0), {0.3F, 0.2F, 0.6F});
  EXPECT_THAT(standpoint_in(scene_of({head, eye})).reason, HasSubstr("inside a closed object"));
}

TEST(Standpoint, IsInTheMiddleOfARoom) {
  expect_in_the_middle(scene_of({inward_box({1, 2, 3}, 2.0F, 0)}), {1, 2, 3});
}

TEST(Standpoint, IsInTheMiddleOfARoomWithThickWalls) {
  expect_in_the_middle(scene_of({inward_box({1, 2, 3}, 2.0F, 0), outward_box({1, 2, 3}, 2.5F)}),
                       {1, 2, 3});
}

/// Walls that face outwards, as whoever puts furniture into a cube leaves them.
TEST(Standpoint, IsInTheMiddleOfAFurnishedBox) {
  const Scene scene = scene_of({outward_box(Vec3(0.0F), 4.0F), outward_box({0, -2, -2}, 1.0F),
                                outward_box({2, -2, 1}, 1.0F), outward_box({-2, 0, 1}, 1.0F)});
  expect_in_the_middle(scene, Vec3(0.0F));
}

TEST(Standpoint, IsInTheMiddleOfABoxThatIsLitFromWithin) {
  Scene scene = scene_of({outward_box(Vec3(0.0F), 2.0F)});
  scene.lights.resize(1);
  scene.lights[0].position = {1.0F, 1.5F, 0.5F};
  expect_in_the_middle(scene, Vec3(0.0F));
  scene.lights[0].position = {1.0F, 4.0F, 0.5F};
  EXPECT_THAT(standpoint_in(scene).reason, HasSubstr("inside a closed object"));
}

TEST(Standpoint, IsInTheMiddleOfWhatIsOpen) {
  expect_in_the_middle(scene_of({torus(2.0F, 0.5F, 32, 0)}), Vec3(0.0F));
  expect_in_the_middle(scene_of({outward_box({-3, 0, 0}, 1.0F), outward_box({3, 0, 0}, 1.0F)}),
                       Vec3(0.0F));
}

/// Its diagonal is sqrt(8) m long.
TEST(Standpoint, IsBesideAFlatScene) {
  const Standpoint wall = standpoint_in(scene_of({quad({0, 0, 5}, {2, 0, 0}, {0, 2, 0}, 0)}));
  expect_near(wall.position, {1, 1, 5 + std::sqrt(8.0F)});
  const Standpoint floor = standpoint_in(scene_of({quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, 0)}));
  expect_near(floor.position, {0, 2, 2});
  EXPECT_NEAR(floor.heading.azimuth_rad, 0.0, 1e-6);
  EXPECT_NEAR(floor.heading.elevation_rad, radians(-45.0), 1e-6);
  EXPECT_THAT(floor.reason, HasSubstr("flat"));
}

TEST(Standpoint, IsFiniteInScenesOfAnySize) {
  for (const float size : {1e-30F, 1e-10F, 1e10F, 1e30F, 3e38F}) {
    const Scene box = scene_of({outward_box(Vec3(0.0F), size)});
    EXPECT_TRUE(is_finite(standpoint_in(box).position)) << size;
    const Scene wall = scene_of({quad(Vec3(-size), {size, 0, 0}, {0, size, 0}, 0)});
    EXPECT_TRUE(is_finite(standpoint_in(wall).position)) << size;
  }
}

TEST(Standpoint, OfAnEmptySceneIsItsOrigin) { expect_in_the_middle(Scene{}, Vec3(0.0F)); }

}  // namespace
}  // namespace foveola::test
