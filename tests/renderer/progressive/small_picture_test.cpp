#include "renderer/progressive/small_picture.h"

#include <limits>

#include "renderer/stability/shapes.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// 90 degrees wide and high, ahead.
Viewport ahead() { return {{}, {.horizontal_deg = 90.0, .vertical_deg = 90.0}}; }

std::vector<DVec3> picture_of(const Scene& scene, const SmallPictureSettings& settings,
                              int threads = 1) {
  const Workers workers(threads);
  return small_picture(PathTracer(scene, workers), Vec3(0.0F), ahead(), settings, workers);
}

/// A lamp over the upper left quarter of the view, before surroundings of `radiance`.
Scene quarter_of_light(const Rgb& light, float radiance) {
  Scene scene;
  scene.meshes = {quad({-1.0F, 0.0F, -1.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 0)};
  scene.materials = {lamp(light)};
  scene.environment = constant_environment(radiance);
  return scene;
}

TEST(SmallPicture, HasItsRowsFromTheTopLeft) {
  EXPECT_THAT(picture_of(quarter_of_light(Rgb(3.0F, 2.0F, 1.0F), 0.25F), {.size = {4, 2}}),
              ElementsAre(DVec3(3.0, 2.0, 1.0), DVec3(3.0, 2.0, 1.0), DVec3(0.25), DVec3(0.25),
                          DVec3(0.25), DVec3(0.25), DVec3(0.25), DVec3(0.25)));
}

/// The first 16 Sobol points are one to each quarter of a quarter.
TEST(SmallPicture, APixelIsTheMeanOfItsSamples) {
  EXPECT_THAT(picture_of(quarter_of_light(Rgb(4.0F), 0.0F), {.size = {1, 1}}),
              ElementsAre(DVec3(1.0)));
}

TEST(SmallPicture, WhatIsNotFiniteCountsAsBlack) {
  const Rgb infinite(std::numeric_limits<float>::infinity());
  EXPECT_THAT(picture_of(quarter_of_light(infinite, 1.0F), {.size = {1, 1}}),
              ElementsAre(DVec3(0.75)));
}

TEST(SmallPicture, DependsOnTheSeedAndNotOnTheThreads) {
  Scene room;
  room.meshes = {inward_box(Vec3(0.0F), 2.0F, 0), quad({-1, 1.9F, -1}, {2, 0, 0}, {0, 0, 2}, 1)};
  room.materials = {matte(Rgb(0.5F)), lamp(Rgb(5.0F), true)};
  const SmallPictureSettings settings{.size = {8, 6}, .samples_per_pixel = 4};
  const std::vector<DVec3> picture = picture_of(room, settings);
  EXPECT_EQ(picture, picture_of(room, settings, 3));
  SmallPictureSettings other = settings;
  other.trace.seed = 1;
  EXPECT_NE(picture, picture_of(room, other));
}

}  // namespace
}  // namespace foveola::test
