// What must neither be lost nor gained on the way: at the rims of smooth-shaded things, in coloured
// water, where numbers fail, and by the tracer's shorter ways.
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/stability/furnished_room.h"
#include "tests/renderer/trace/paths.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

/// Balls of triangles whose normals are interpolated.
Scene smooth_shaded_ball(const Material& material) {
  Scene scene;
  scene.materials = {material};
  scene.meshes = {inside_out(inward_sphere(1.0F, 3, 0))};
  scene.environment = constant_environment(1.0F);
  return scene;
}

TEST(TransportTest, SmoothShadedMirrorsLoseNothingAtTheirRims) {
  const Scene scene = smooth_shaded_ball(metal(1.0F, 0.0F));
  const PathTracer tracer(scene, workers());
  for (const Rgb& value : trace(tracer, Vec3(0, 0, 1.3F), jobs_all_around(20000), 8)) {
    EXPECT_NEAR(value.g, 1.0F, 1e-5F);
  }
}

TEST(TransportTest, SmoothShadedGlassLosesNothingAtItsRims) {
  const Scene scene = smooth_shaded_ball(glass());
  const PathTracer tracer(scene, workers());
  const auto radiance = trace(tracer, Vec3(0, 0, 1.3F), jobs_all_around(100000), 200);
  expect_mean(mean_of(radiance), 1.0, 1e-3);
}

/// A closed box of glass that bends nothing but absorbs, from (-2, -2, -2) to (2, 2, 2), and in it
/// a grey floor at y = -1.
Scene coloured_water() {
  Material water = glass();
  water.ior = 1.0F;
  water.attenuation_color = Rgb(0.25F, 0.5F, 1.0F);
  water.attenuation_distance_m = 1.0F;
  Scene scene;
  scene.materials = {water, matte(Rgb(0.5F))};
  scene.meshes = {inside_out(inward_box(Vec3(0.0F), 2.0F, 0)),
                  quad(Vec3(-1.5F, -1, 1.5F), Vec3(3, 0, 0), Vec3(0, 0, -3), 1)};
  return scene;
}

TEST(TransportTest, ShadowRaysAreAbsorbedInSolids) {
  Scene scene = coloured_water();
  scene.lights = {{.position = Vec3(1.0F, 0.5F, 0.0F), .intensity = Rgb(3.0F)}};
  const double distance = std::sqrt(1.0 + 1.5 * 1.5);
  const double reflected = 0.5 / std::numbers::pi * 3.0 * (1.5 / distance) / (distance * distance);
  // The camera is outside: its ray comes 3 m through the water.
  const auto radiance =
      trace(PathTracer(scene, workers()), Vec3(0, 10, 0), jobs_along({0, -1, 0}, 100), 2);
  const DVec3 attenuation(0.25, 0.5, 1.0);
  for (const Rgb& value : radiance) {
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = reflected * std::pow(attenuation[channel], 3.0 + distance);
      EXPECT_NEAR(value[channel], expected, 1e-4 * expected);
    }
  }
}

/// Light samples and rays that find the light by chance must agree on what is absorbed.
TEST(TransportTest, LampsInSolidsAreAbsorbedWhicheverWayTheyAreFound) {
  Scene scene = coloured_water();
  scene.materials.push_back(emitter(5.0F));
  scene.meshes.push_back(quad(Vec3(-0.5F, 1, -0.5F), Vec3(1, 0, 0), Vec3(0, 0, 1), 2));
  double expected = 0.0;
  constexpr int steps = 200;
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      const double x = (i + 0.5) / steps - 0.5 - 1.2;
      const double z = (k + 0.5) / steps - 0.5;
      const double squared = x * x + 4.0 + z * z;
      expected += 5.0 * 4.0 / (squared * squared) * std::pow(0.5, std::sqrt(squared));
    }
  }
  expected *= 0.5 / std::numbers::pi / (steps * steps) * std::pow(0.5, 3.0);
  const auto radiance =
      trace(PathTracer(scene, workers()), Vec3(1.2F, 10, 0), jobs_along({0, -1, 0}, 20000), 2);
  expect_mean(mean_of(radiance), expected, 2e-3);
}

/// A closed room of 4 m that shines 0.8 and whose sides show a half of a texture, which reflects
/// 0.2, so that 1 comes from everywhere. The other half is white.
Scene room_of_half_a_texture() {
  constexpr int size = 256;
  DecodedImage image{.width = size, .height = size, .channels = 1, .texels = {}};
  for (int i = 0; i < size * size; ++i) {
    image.texels.push_back(i % size < size / 2 ? 51 : 255);
  }
  Material wall = matte(Rgb(1.0F));
  wall.emission = Rgb(0.8F);
  wall.base_color_texture.texture = 0;
  Scene scene;
  scene.materials = {wall};
  scene.textures.emplace_back(std::move(image), /*is_srgb=*/false, Sampler{});
  Mesh box = inward_box(Vec3(0.0F), 2.0F, 0);
  for (int side = 0; side < 6; ++side) {
    // In the order of a side's corners, and not quite up to where the halves meet.
    const std::vector<Vec2> corners{{0.02F, 0.0F}, {0.48F, 0.0F}, {0.02F, 1.0F}, {0.48F, 1.0F}};
    box.uv_sets.resize(1);
    box.uv_sets[0].insert(box.uv_sets[0].end(), corners.begin(), corners.end());
  }
  scene.meshes = {std::move(box)};
  return scene;
}

// Averaged over all that a ray stands for, the sides would show some of the other half.
TEST(TransportTest, TexturesShowWhatIsInView) {
  const Scene scene = room_of_half_a_texture();
  const std::vector<SampleJob> jobs = jobs_all_around(200000);
  std::vector<Rgb> radiance(jobs.size());
  PathTracer(scene, workers())
      .trace(Vec3(0.5F, 0.0F, 0.0F), jobs, radiance,
             {.max_depth = 10, .seed = 1, .pixel_angle_rad = 0.025F}, workers());
  expect_mean(mean_of(radiance), 1.0, 2e-3);
}

TEST(TransportTest, WhatIsNotANumberIsNotHidden) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Material covered = dielectric(0.5F);
  covered.clearcoat = 1.0F;
  Material shiny = dielectric(0.5F);
  for (Material material :
       {matte(Rgb(0.5F)), shiny, covered, metal(0.5F, 0.4F), metal(0.5F, 0.0F)}) {
    material.base_color.r = nan;
    Scene scene;
    scene.materials = {material};
    scene.meshes = {quad(Vec3(-50, -1, 50), Vec3(100, 0, 0), Vec3(0, 0, -100), 0)};
    scene.environment = constant_environment(1.0F);
    for (const Rgb& value :
         trace(PathTracer(scene, workers()), Vec3(0.0F), jobs_along({0, -1, 0}, 64), 2)) {
      EXPECT_FALSE(is_finite(value));
    }
  }
}

// Rounding sends a few paths elsewhere; the others are the same.
TEST(TransportTest, TheGeneralPathSeesTheSame) {
  const Scene scene = room_of_everything();
  const PathTracer tracer(scene, workers());
  const std::vector<SampleJob> jobs = jobs_all_around(20000);
  const std::vector<Rgb> usual = trace(tracer, room_viewpoint, jobs, 6);
  std::vector<Rgb> general(jobs.size());
  tracer.trace(room_viewpoint, jobs, general,
               {.max_depth = 6, .seed = 1, .uses_general_path = true}, workers());
  std::size_t differing = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    differing += std::abs(usual[i].g - general[i].g) > 1e-3F * usual[i].g ? 1 : 0;
  }
  EXPECT_LT(differing, jobs.size() / 50);
  EXPECT_NEAR(mean_of(general).mean(), mean_of(usual).mean(), mean_of(usual).standard_error());
}

}  // namespace
}  // namespace foveola
