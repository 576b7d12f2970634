#include "renderer/trace/paths/direct_shading.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/renderer/trace/scenes.h"

namespace foveola {
namespace {

constexpr double ambient = 0.3;
constexpr double head_light = 0.7;

Rgb color_along(const Scene& scene, const Vec3& direction, float pixel_angle_rad = 0.0F) {
  const Workers workers(1);
  const RayScene rays(scene, workers);
  return direct_color(scene, rays, Vec3(0.0F), glm::normalize(direction), pixel_angle_rad);
}

/// Faces the origin, two metres across and so far away.
Mesh facing_quad(float distance_m, int material) {
  return quad(Vec3(-1, -1, -distance_m), Vec3(2, 0, 0), Vec3(0, 2, 0), material);
}

void expect_near(const Rgb& color, const Rgb& expected, double tolerance) {
  EXPECT_NEAR(color.r, expected.r, tolerance);
  EXPECT_NEAR(color.g, expected.g, tolerance);
  EXPECT_NEAR(color.b, expected.b, tolerance);
}

TEST(DirectShading, ASphereIsBrightInTheMiddleAndDarkAtItsRim) {
  const Vec3 center(0, 0, -4);
  Scene scene;
  scene.materials = {matte({0.8F, 0.4F, 0.2F})};
  scene.meshes = {placed(inside_out(inward_sphere(1.0F, 5, 0)), 1.0F, Quat(1, 0, 0, 0), center)};
  for (const float across : {0.0F, 0.05F, -0.1F, 0.2F}) {
    const Vec3 direction = glm::normalize(Vec3(across, 0.5F * across, -1.0F));
    // Where the line meets the unit sphere, by its quadratic equation.
    const float along = glm::dot(direction, center);
    const float distance = along - std::sqrt(along * along - 15.0F);
    const double cosine = glm::dot(center - distance * direction, direction);
    expect_near(color_along(scene, direction),
                static_cast<float>(ambient + head_light * cosine) * Rgb(0.8F, 0.4F, 0.2F), 2e-3);
  }
}

TEST(DirectShading, TexturesAreSeen) {
  Material material = matte(Rgb(1.0F));
  material.base_color_texture.texture = 0;
  Scene scene;
  scene.materials = {material};
  scene.meshes = {facing_quad(2.0F, 0)};
  const std::vector<std::uint8_t> texels{255, 0, 0,   255, 0,   255, 0, 255,
                                         0,   0, 255, 255, 102, 51,  0, 255};
  scene.textures.emplace_back(2, 2, texels, false, Wrap::clamp_to_edge, Wrap::clamp_to_edge);
  const auto shade = static_cast<float>(ambient + head_light * 2.0 / std::sqrt(4.5));
  expect_near(color_along(scene, {-0.5F, -0.5F, -2}), shade * Rgb(1, 0, 0), 1e-5);
  expect_near(color_along(scene, {0.5F, -0.5F, -2}), shade * Rgb(0, 1, 0), 1e-5);
  expect_near(color_along(scene, {-0.5F, 0.5F, -2}), shade * Rgb(0, 0, 1), 1e-5);
  expect_near(color_along(scene, {0.5F, 0.5F, -2}), shade * Rgb(0.4F, 0.2F, 0), 1e-5);
}

TEST(DirectShading, TexturesAreAveragedOverAPixel) {
  Material material = matte(Rgb(1.0F));
  material.base_color_texture.texture = 0;
  Scene scene;
  scene.materials = {material};
  scene.meshes = {facing_quad(2.0F, 0)};
  std::vector<std::uint8_t> chequers;
  for (int i = 0; i < 64 * 64; ++i) {
    const std::uint8_t value = (i % 64 + i / 64) % 2 == 0 ? 255 : 0;
    chequers.insert(chequers.end(), {value, value, value, 255});
  }
  scene.textures.emplace_back(64, 64, chequers, false, Wrap::repeat, Wrap::repeat);
  const Vec3 towards_a_texel(1.0F / 64.0F, 1.0F / 64.0F, -2);
  EXPECT_NEAR(color_along(scene, towards_a_texel).r, 1.0, 1e-3);
  const float eighth_of_the_quad = 0.25F / 2.0F;
  EXPECT_NEAR(color_along(scene, towards_a_texel, eighth_of_the_quad).r, 0.5, 1e-2);
}

TEST(DirectShading, BlendedSurfacesShowWhatIsBehindThemWithoutNoise) {
  Material veil = matte({0.8F, 0.8F, 0.0F});
  veil.alpha_mode = AlphaMode::blend;
  veil.alpha = 0.25F;
  Scene scene;
  scene.materials = {veil, matte({0.0F, 0.4F, 1.0F})};
  scene.meshes = {facing_quad(2.0F, 0), facing_quad(3.0F, 1)};
  const Rgb expected = 0.25F * Rgb(0.8F, 0.8F, 0.0F) + 0.75F * Rgb(0.0F, 0.4F, 1.0F);
  expect_near(color_along(scene, {1e-3F, -2e-3F, -1}), expected, 1e-4);
  expect_near(color_along(scene, {-2e-3F, 1e-3F, -1}), expected, 1e-4);  // of its other triangle
}

TEST(DirectShading, WhatIsMaskedIsNotThere) {
  Material mask = matte(Rgb(1.0F));
  mask.alpha_mode = AlphaMode::mask;
  mask.alpha_cutoff = 0.5F;
  Scene scene;
  scene.materials = {mask, matte({0.0F, 0.4F, 1.0F})};
  scene.meshes = {facing_quad(2.0F, 0), facing_quad(3.0F, 1)};
  scene.meshes[0].colors.assign(4, Vec4(1, 1, 1, 0.4F));
  expect_near(color_along(scene, {1e-3F, -2e-3F, -1}), Rgb(0.0F, 0.4F, 1.0F), 1e-4);
  scene.meshes[0].colors.assign(4, Vec4(1, 1, 1, 0.6F));
  expect_near(color_along(scene, {1e-3F, -2e-3F, -1}), Rgb(1.0F), 1e-4);
}

TEST(DirectShading, ThinSurfacesAreSeenThroughInTheirColour) {
  Material window = matte({0.8F, 0.6F, 0.4F});
  window.transmission = 0.75F;
  window.roughness = 0.0F;
  Scene scene;
  scene.materials = {window, matte({0.5F, 0.5F, 1.0F})};
  scene.meshes = {facing_quad(2.0F, 0), facing_quad(3.0F, 1)};
  const Rgb expected = Rgb(0.8F, 0.6F, 0.4F) * (0.25F * Rgb(1.0F) + 0.75F * Rgb(0.5F, 0.5F, 1.0F));
  expect_near(color_along(scene, {1e-3F, -2e-3F, -1}), expected, 1e-4);
}

TEST(DirectShading, WhatShinesIsBrightAndKeepsItsHue) {
  Scene scene;
  scene.materials = {lamp({8.0F, 4.0F, 2.0F})};
  scene.meshes = {facing_quad(2.0F, 0)};
  expect_near(color_along(scene, {0.5F, 0.3F, -1}), Rgb(1.0F, 0.5F, 0.25F), 1e-5);
  scene.materials[0] = matte({0.2F, 0.3F, 0.4F});
  scene.materials[0].unlit = true;
  expect_near(color_along(scene, {0.5F, 0.3F, -1}), Rgb(0.2F, 0.3F, 0.4F), 1e-6);
}

TEST(DirectShading, WithoutASurfaceThereIsTheBackground) {
  EXPECT_EQ(color_along(Scene{}, {0, 0, -1}), Rgb(0.25F, 0.3F, 0.4F));
}

/// More sheets than anybody looks through.
TEST(DirectShading, EndsAmongManyTransparentLayers) {
  Material veil = matte(Rgb(1.0F));
  veil.alpha_mode = AlphaMode::blend;
  veil.alpha = 0.01F;
  Scene scene;
  scene.materials = {veil};
  for (int i = 0; i < 1000; ++i) {
    scene.meshes.push_back(facing_quad(1.0F + 0.01F * static_cast<float>(i), 0));
  }
  const Rgb color = color_along(scene, {1e-3F, -2e-3F, -1});
  EXPECT_GT(color.r, 0.9F);
  EXPECT_LE(color.r, 1.0F);
}

}  // namespace
}  // namespace foveola
