#include "renderer/trace/lights.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/random.h"
#include "renderer/trace/ray_scene.h"
#include "scenes.h"
#include "statistics.h"

namespace foveola {
namespace {

struct Numbers {
  float kind;
  Vec2 choice;
  Vec2 point;

  explicit Numbers(SampleStream& random)
      : kind(random.next_1d()), choice(random.next_2d()), point(random.next_2d()) {}
};

Receiver facing_up(const Vec3& position) {
  return {.position = position, .normal = Vec3(0, 1, 0), .transmits = false};
}

/// The irradiance on a horizontal plane through `position`, without occlusion.
MeanEstimate irradiance_at(const Lights& lights, const Vec3& position, int samples) {
  const Receiver receiver = facing_up(position);
  MeanEstimate estimate;
  for (int i = 0; i < samples; ++i) {
    SampleStream random(3, 0, static_cast<std::uint32_t>(i));
    const Numbers numbers(random);
    const auto light = lights.sample(receiver, numbers.kind, numbers.choice, numbers.point);
    estimate.add(light ? light->radiance.r * std::max(0.0F, light->direction.y) / light->pdf : 0.0);
  }
  return estimate;
}

/// The form factor from a point to a rectangle parallel to its plane, one of whose corners lies
/// straight above it (Siegel and Howell, configuration factor B-4). a, b: sides over distance.
double corner_form_factor(double a, double b) {
  const double x = std::sqrt(1.0 + a * a);
  const double y = std::sqrt(1.0 + b * b);
  return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2.0 * std::numbers::pi);
}

/// A ceiling light of radiance 4 whose front looks down, from (0, 2, 0) to (sides.x, 2, sides.y).
Scene ceiling_light(const Vec2& sides, bool double_sided = false) {
  Scene scene;
  scene.materials = {emitter(4.0F, double_sided)};
  scene.meshes = {quad(Vec3(0, 2, 0), Vec3(sides.x, 0, 0), Vec3(0, 0, sides.y), 0)};
  return scene;
}

TEST(LightsTest, RectangleGivesTheIrradianceOfItsFormFactor) {
  const Scene scene = ceiling_light({1.0F, 3.0F});
  const double expected = std::numbers::pi * 4.0 * corner_form_factor(0.5, 1.5);
  expect_mean(irradiance_at(Lights(scene), Vec3(0.0F), 40000), expected);
}

TEST(LightsTest, SingleSidedRectangleIsDarkFromBehind) {
  const Scene scene = ceiling_light({1.0F, 1.0F});
  EXPECT_EQ(irradiance_at(Lights(scene), Vec3(0.5F, 5.0F, 0.5F), 100).mean(), 0.0);
}

TEST(LightsTest, DoubleSidedRectangleShinesBothWays) {
  const Scene scene = ceiling_light({2.0F, 2.0F}, true);
  const Lights lights(scene);
  const double expected = std::numbers::pi * 4.0 * corner_form_factor(1.0, 1.0);
  expect_mean(irradiance_at(lights, Vec3(0.0F), 40000), expected);
  SampleStream random(1, 0, 0);
  const Numbers numbers(random);
  EXPECT_TRUE(
      lights.sample({.position = Vec3(0, 4, 0)}, numbers.kind, numbers.choice, numbers.point));
}

TEST(LightsTest, ManyUnequalTrianglesAndAConstantSkyAddUp) {
  Scene scene = ceiling_light({1.0F, 3.0F});
  scene.materials.push_back(emitter(0.5F));
  scene.meshes.push_back(quad(Vec3(0, 2, 0), Vec3(-2, 0, 0), Vec3(0, 0, -2), 1));
  scene.environment = constant_environment(0.25F);
  const double expected = std::numbers::pi * (4.0 * corner_form_factor(0.5, 1.5) +
                                              0.5 * corner_form_factor(1.0, 1.0) + 0.25);
  expect_mean(irradiance_at(Lights(scene), Vec3(0.0F), 100000), expected);
}

TEST(LightsTest, DensitiesAgreeWithThoseOfSampledPoints) {
  Scene scene = ceiling_light({1.0F, 3.0F});
  scene.environment = constant_environment(0.1F);
  const Lights lights(scene);
  const RayScene rays(scene, Workers(1));
  // From far the light is sampled by area, from near by solid angle.
  for (const float y : {0.1F, -60.0F}) {
    const Receiver receiver = facing_up(Vec3(0.3F, y, -0.2F));
    for (std::uint32_t i = 0; i < 200; ++i) {
      SampleStream random(4, 0, i);
      const Numbers numbers(random);
      const auto light = lights.sample(receiver, numbers.kind, numbers.choice, numbers.point);
      ASSERT_TRUE(light);
      if (std::isinf(light->shadow_ray.t_max)) {
        EXPECT_FLOAT_EQ(lights.environment_pdf(light->direction), light->pdf);
        continue;
      }
      const Hit hit = rays.closest_hit(receiver.position, light->direction);
      ASSERT_FALSE(hit.missed());
      EXPECT_NEAR(lights.triangle_pdf(receiver, hit, hit.t, light->direction.y), light->pdf,
                  1e-4F * light->pdf);
    }
  }
}

TEST(LightsTest, TrianglesWithoutAreaOrFiniteCornersDoNotShine) {
  Scene scene;
  scene.materials = {emitter(1.0F)};
  scene.meshes = {quad(Vec3(0.0F), Vec3(1, 0, 0), Vec3(2, 0, 0), 0),
                  quad(Vec3(0.0F), Vec3(NAN, 0, 0), Vec3(0, 0, 1), 0),
                  quad(Vec3(0.0F), Vec3(INFINITY, 0, 0), Vec3(0, 0, 1), 0)};
  EXPECT_TRUE(Lights(scene).empty());
}

TEST(LightsTest, BlackEnvironmentIsNoLight) {
  Scene scene;
  scene.environment = constant_environment(0.0F);
  EXPECT_TRUE(Lights(scene).empty());
  EXPECT_EQ(Lights(scene).environment_radiance(Vec3(0, 1, 0)), Rgb(0.0F));
}

TEST(LightsTest, TexturedEmitterIsWeighedByItsTexturesMean) {
  Scene scene = ceiling_light({1.0F, 1.0F});
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].emissive_texture.texture = 0;
  // Half black, half white: half the power of the plain one beside it.
  scene.textures.emplace_back(2, 1, std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 255, 255},
                              false, Wrap::clamp_to_edge, Wrap::clamp_to_edge);
  scene.meshes.push_back(quad(Vec3(0, 2, 0), Vec3(-1, 0, 0), Vec3(0, 0, -1), 1));
  const Lights lights(scene);
  const Hit plain{.t = 1.0F, .barycentric = {}, .object = 0, .triangle = 0};
  const Hit textured{.t = 1.0F, .barycentric = {}, .object = 1, .triangle = 0};
  // So far away that points are uniform in area.
  const Receiver receiver = facing_up(Vec3(0, -500, 0));
  EXPECT_NEAR(lights.triangle_pdf(receiver, plain, 1.0F, 1.0F), 2.0 / 3.0, 1e-3);
  EXPECT_NEAR(lights.triangle_pdf(receiver, textured, 1.0F, 1.0F), 1.0 / 3.0, 1e-3);
}

}  // namespace
}  // namespace foveola
