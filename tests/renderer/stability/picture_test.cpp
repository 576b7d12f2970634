#include "renderer/stability/picture.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "renderer/stability/furnished_room.h"
#include "renderer/stability/shapes.h"

namespace foveola {
namespace {

RadianceEstimate block(double mean, double standard_error) {
  return {.mean = DVec3(mean), .standard_error = DVec3(standard_error), .samples = 1};
}

TEST(PictureTest, DifferenceIsInStandardErrorsOfBoth) {
  const std::vector<RadianceEstimate> reference{block(1.0, 0.03), block(2.0, 0.03)};
  const std::vector<RadianceEstimate> picture{block(1.1, 0.04), block(2.0, 0.04)};
  EXPECT_NEAR(picture_difference("", picture, reference, 0.0).measured, 2.0, 1e-9);
  EXPECT_NEAR(picture_difference("", picture, reference, 0.05).measured, 1.0, 1e-9);
  EXPECT_EQ(picture_difference("", picture, reference, 0.2).measured, 0.0);
}

TEST(PictureTest, WhatIsNotANumberFails) {
  const std::vector<RadianceEstimate> reference{block(1.0, 0.03), block(2.0, 0.03)};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(
      picture_difference("", {block(nan, 0.03), block(2.0, 0.03)}, reference, 0.0).passes());
  EXPECT_FALSE(
      picture_difference("", {block(1.0, 0.03), block(nan, nan)}, reference, 0.0).passes());
}

/// Blocks lie where the film has them: a lamp at azimuth 90 degrees, elevation 45.
TEST(PictureTest, BlocksFollowTheFilmsConvention) {
  Scene scene;
  scene.materials = {lamp(Rgb(1.0F), true)};
  scene.meshes = {placed(inward_sphere(0.05F, 1, 0), 1.0F, Quat(1, 0, 0, 0), Vec3(1, 1, 0))};
  const Workers workers(2);
  const StabilityRun run{.workers = workers, .effort = {.picture_samples_per_pixel = 32}};
  const auto blocks = render_blocks(PathTracer(scene, workers), Vec3(0.0F), {.max_depth = 0}, run);
  ASSERT_EQ(blocks.size(), 32U);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    // Columns of 45 degrees from -180, rows from the top: the lamp lies at a corner of four blocks.
    const bool holds_lamp = i == 5 || i == 6 || i == 13 || i == 14;
    EXPECT_EQ(blocks[i].mean.g > 0.0, holds_lamp) << i;
  }
}

TEST(PictureTest, ATenthLessLightIsSeen) {
  const Workers workers(2);
  const StabilityRun run{.workers = workers, .effort = {.picture_samples_per_pixel = 64}};
  Scene scene = furnished_room();
  const auto reference =
      render_blocks(PathTracer(scene, workers), room_viewpoint, {.seed = 1}, run);
  const auto again = render_blocks(PathTracer(scene, workers), room_viewpoint, {.seed = 2}, run);
  EXPECT_TRUE(picture_difference("", again, reference, 0.0).passes());
  for (Material& material : scene.materials) {
    material.emission *= 0.9F;
  }
  const auto darker = render_blocks(PathTracer(scene, workers), room_viewpoint, {.seed = 3}, run);
  EXPECT_FALSE(picture_difference("", darker, reference, 0.0).passes());
}

}  // namespace
}  // namespace foveola
