#include "renderer/trace/lights/lights.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/trace/surfaces/triangle.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/statistics.h"
#include "tests/renderer/view/chi_squared.h"

namespace foveola {
namespace {

struct Numbers {
  float kind;
  Vec2 choice;
  Vec2 point;

  explicit Numbers(SampleStream& random)
      : kind(random.next_1d()), choice(random.next_2d()), point(random.next_2d()) {}
};

ShadingPoint facing_up(const Vec3& position) {
  return {.position = position, .normal = Vec3(0, 1, 0), .transmits = false};
}

/// The irradiance on a horizontal plane through `position`, without occlusion.
MeanEstimate irradiance_at(const Lights& lights, const Vec3& position, int samples) {
  const ShadingPoint shading_point = facing_up(position);
  MeanEstimate estimate;
  for (int i = 0; i < samples; ++i) {
    SampleStream random(3, 0, static_cast<std::uint32_t>(i));
    const Numbers numbers(random);
    const auto light = lights.sample(shading_point, numbers.kind, numbers.choice, numbers.point);
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
    const ShadingPoint shading_point = facing_up(Vec3(0.3F, y, -0.2F));
    for (std::uint32_t i = 0; i < 200; ++i) {
      SampleStream random(4, 0, i);
      const Numbers numbers(random);
      const auto light = lights.sample(shading_point, numbers.kind, numbers.choice, numbers.point);
      ASSERT_TRUE(light);
      if (std::isinf(light->t_max)) {
        EXPECT_FLOAT_EQ(lights.distant_light(shading_point, light->direction).pdf, light->pdf);
        continue;
      }
      const Hit hit =
          rays.closest_hit({.origin = shading_point.position, .direction = light->direction});
      ASSERT_FALSE(hit.missed());
      EXPECT_NEAR(lights.triangle_pdf(shading_point, hit, hit.t, light->direction.y), light->pdf,
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

TEST(LightsTest, AnInfiniteTriangleDoesNotHideTheOtherLights) {
  Scene scene = ceiling_light({1.0F, 3.0F});
  scene.meshes.push_back(quad(Vec3(0.0F), Vec3(INFINITY, 0, 0), Vec3(0, 0, 1), 0));
  scene.environment = constant_environment(0.25F);
  const double expected = std::numbers::pi * (4.0 * corner_form_factor(0.5, 1.5) + 0.25);
  for (const std::size_t max_in_table : {std::size_t{32}, std::size_t{0}}) {
    expect_mean(irradiance_at(Lights(scene, {}, max_in_table), Vec3(0.0F), 40000), expected);
  }
}

TEST(LightsTest, BlackEnvironmentIsNoLight) {
  Scene scene;
  scene.environment = constant_environment(0.0F);
  EXPECT_TRUE(Lights(scene).empty());
  EXPECT_EQ(Lights(scene).distant_light({}, Vec3(0, 1, 0)).radiance, Rgb(0.0F));
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
  const ShadingPoint shading_point = facing_up(Vec3(0, -500, 0));
  EXPECT_NEAR(lights.triangle_pdf(shading_point, plain, 1.0F, 1.0F), 2.0 / 3.0, 1e-3);
  EXPECT_NEAR(lights.triangle_pdf(shading_point, textured, 1.0F, 1.0F), 1.0 / 3.0, 1e-3);
}

/// All that rays can meet: a lamp overhead and one to the side, a sky, and a large sun.
Scene visible_lights() {
  Scene scene = ceiling_light({2.0F, 3.0F});
  scene.materials.push_back(emitter(6.0F, true));
  scene.meshes.push_back(quad(Vec3(-3, 0, -2), Vec3(0, 2, 0), Vec3(0, 0, 3), 1));
  scene.environment = constant_environment(0.3F);
  scene.lights.push_back({.kind = PunctualLight::Kind::directional,
                          .direction = glm::normalize(Vec3(-1, -1, 1)),
                          .intensity = Rgb(2.0F),
                          .angular_radius_rad = 0.3F});
  return scene;
}

/// With which density sample() draws a direction, asked light by light of what a ray meets.
double density_of(const Lights& lights, const RayScene& rays, const ShadingPoint& shading_point,
                  const Scene& scene, const Vec3& direction) {
  double density = lights.distant_light(shading_point, direction).pdf;
  const Hit hit = rays.closest_hit({.origin = shading_point.position, .direction = direction});
  if (!hit.missed()) {
    const Vec3 normal = Triangle(scene, hit.object, hit.triangle).front_normal();
    const float cosine = -glm::dot(normal, direction);
    if (cosine > 0.0F ||
        scene.materials[static_cast<std::size_t>(scene.mesh_of(hit.object).material)]
            .double_sided) {
      density += lights.triangle_pdf(shading_point, hit, hit.t, std::abs(cosine));
    }
  }
  return density;
}

/// How directions are drawn for a point in visible_lights().
void expect_drawn_by_their_densities(const Lights& lights, const ShadingPoint& shading_point,
                                     int tests) {
  const Scene scene = visible_lights();
  const RayScene rays(scene, Workers(1));
  const auto density = [&](const Vec3& w) {
    return density_of(lights, rays, shading_point, scene, w);
  };
  const Vec3 pole = glm::normalize(Vec3(0.3F, 1, 0.2F));
  EXPECT_NEAR(test::integral_over_sphere(density, pole), 1.0, 2e-3);
  std::vector<Vec3> directions;
  for (std::uint32_t i = 0; i < 50000; ++i) {
    SampleStream random(5, i, 0);
    const Numbers numbers(random);
    const auto light = lights.sample(shading_point, numbers.kind, numbers.choice, numbers.point);
    ASSERT_TRUE(light);
    directions.push_back(light->direction);
  }
  EXPECT_GT(test::chi_squared_p_value(directions, density, pole), sidak_level(tests));
}

/// From the table and from the tree, for a surface that all lamps shine on.
TEST(LightsTest, DirectionsAreDrawnByTheSumOfAllDensities) {
  const Scene scene = visible_lights();
  const ShadingPoint shading_point{.position = Vec3(0.2F, 0.3F, 0.1F), .normal = Vec3(0, 1, 0)};
  for (const std::size_t max_in_table : {std::size_t{32}, std::size_t{0}}) {
    expect_drawn_by_their_densities(Lights(scene, {}, max_in_table), shading_point, 2);
  }
}

TEST(LightsTest, OtherWaysToDrawThemKnowTheirDensitiesToo) {
  const Scene scene = visible_lights();
  ShadingPoint shading_point{.position = Vec3(0.2F, 0.3F, 0.1F),
                             .normal = glm::normalize(Vec3(0.1F, 1, -0.3F))};
  for (const LightSampling& sampling :
       {LightSampling{.selection = LightSelection::by_power_alone},
        LightSampling{.selection = LightSelection::uniform},
        LightSampling{.triangles_by_area = true}, LightSampling{.environment_by_cosine = true}}) {
    for (const bool transmits : {false, true}) {
      shading_point.transmits = transmits;
      expect_drawn_by_their_densities(Lights(scene, sampling), shading_point, 8);
    }
  }
}

/// Two triangles, two suns and a sky are five lights, however bright each is.
TEST(LightsTest, UniformSelectionDrawsEachLightAsOften) {
  Scene scene = ceiling_light({1.0F, 3.0F});
  scene.environment = constant_environment(100.0F);
  scene.lights = {{.kind = PunctualLight::Kind::directional,
                   .direction = Vec3(0, -1, 0),
                   .intensity = Rgb(70.0F)},
                  {.kind = PunctualLight::Kind::directional,
                   .direction = Vec3(0, -1, 0),
                   .intensity = Rgb(0.1F)}};
  const Lights lights(scene, {.selection = LightSelection::uniform});
  const ShadingPoint shading_point = facing_up(Vec3(0, -500, 0));
  EXPECT_NEAR(lights.distant_light(shading_point, Vec3(0, 1, 0)).pdf,
              0.2 / (4.0 * std::numbers::pi), 1e-6);
  for (const std::uint32_t triangle : {0U, 1U}) {
    const Hit hit{.t = 1.0F, .barycentric = {}, .object = 0, .triangle = triangle};
    EXPECT_NEAR(lights.triangle_pdf(shading_point, hit, 1.0F, 1.0F), 0.2 / 1.5, 1e-5);
  }
  int bright = 0;
  int dim = 0;
  constexpr int draws = 5000;
  for (std::uint32_t i = 0; i < draws; ++i) {
    SampleStream random(6, i, 0);
    const Numbers numbers(random);
    const auto light = lights.sample(shading_point, numbers.kind, numbers.choice, numbers.point);
    if (light && light->is_delta) {
      EXPECT_FLOAT_EQ(light->pdf, 0.2F);
      ++(light->radiance.r > 1.0F ? bright : dim);
    }
  }
  // Binomial counts, within four standard deviations.
  const double deviation = 4.0 * std::sqrt(draws * 0.2 * 0.8);
  EXPECT_NEAR(bright, 0.2 * draws, deviation);
  EXPECT_NEAR(dim, 0.2 * draws, deviation);
}

/// In the densities of area and of solid angle, 1 m below a corner of the lamp.
TEST(LightsTest, TrianglesCanBeDrawnByTheirArea) {
  const Scene scene = ceiling_light({1.0F, 3.0F});
  const ShadingPoint shading_point = facing_up(Vec3(0, 1, 0));
  const Hit hit{.t = 1.0F, .barycentric = {}, .object = 0, .triangle = 0};
  const Lights by_area(scene, {.selection = LightSelection::uniform, .triangles_by_area = true});
  const Lights by_solid_angle(scene, {.selection = LightSelection::uniform});
  // Half of the draws, in 1.5 square metres, at a distance of 1 m.
  EXPECT_NEAR(by_area.triangle_pdf(shading_point, hit, 1.0F, 1.0F), 0.5 / 1.5, 1e-5);
  EXPECT_GT(by_solid_angle.triangle_pdf(shading_point, hit, 1.0F, 1.0F), 0.6);
}

/// What the floor gets of a constant sky is the same in every sample.
TEST(LightsTest, ACosineSkyGivesAFloorTheSameInEverySample) {
  Scene scene;
  scene.environment = constant_environment(0.25F);
  const Lights lights(scene, {.environment_by_cosine = true});
  const MeanEstimate irradiance = irradiance_at(lights, Vec3(0.0F), 1000);
  EXPECT_NEAR(irradiance.mean(), 0.25 * std::numbers::pi, 1e-6);
  EXPECT_LT(irradiance.standard_error(), 1e-6);
}

/// One light of each kind that no ray meets, above the plane y = 0 at the origin.
TEST(LightsTest, InvisibleLightsAddUp) {
  Scene scene = ceiling_light({1.0F, 3.0F});
  scene.environment = constant_environment(0.25F);
  const Vec3 direction = glm::normalize(Vec3(-1, -2, 0.5F));
  scene.lights = {
      {.kind = PunctualLight::Kind::directional, .direction = direction, .intensity = Rgb(3.0F)},
      {.kind = PunctualLight::Kind::point, .position = Vec3(3, 4, 0), .intensity = Rgb(50.0F)},
      {.kind = PunctualLight::Kind::point,
       .position = Vec3(0, 1, 0),
       .intensity = Rgb(2.0F),
       .radius_m = 0.3F},
      {.kind = PunctualLight::Kind::spot,
       .position = Vec3(0, 5, 0),
       .direction = Vec3(0, -1, 0),
       .intensity = Rgb(30.0F)}};
  const double expected = std::numbers::pi * (4.0 * corner_form_factor(0.5, 1.5) + 0.25) -
                          3.0 * direction.y + 50.0 * 0.8 / 25.0 + 2.0 + 30.0 / 25.0;
  for (const std::size_t max_in_table : {std::size_t{32}, std::size_t{0}}) {
    expect_mean(irradiance_at(Lights(scene, {}, max_in_table), Vec3(0.0F), 100000), expected);
  }
}

/// Triangles of all sizes and brightnesses, some of them double-sided, in a cube of side 2.
Scene confetti(int count) {
  Scene scene;
  scene.materials = {emitter(1.0F), emitter(20.0F), emitter(4.0F, true)};
  Pcg32 random(11);
  const auto in_cube = [&] {
    const double x = random.uniform();
    const double y = random.uniform();
    const double z = random.uniform();
    return 2.0F * Vec3(x, y, z) - 1.0F;
  };
  for (int material = 0; material < 3; ++material) {
    Mesh mesh;
    mesh.material = material;
    for (int i = 0; i < count; ++i) {
      const Vec3 corner = in_cube();
      const auto size = static_cast<float>(0.3 * random.uniform() * random.uniform());
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back(corner);
      mesh.positions.push_back(corner + size * in_cube());
      mesh.positions.push_back(corner + size * in_cube());
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    scene.meshes.push_back(mesh);
  }
  return scene;
}

TEST(LightsTest, TreeAndTableExpectTheSame) {
  Scene scene = confetti(100);
  scene.lights.push_back({.position = Vec3(0.2F, 0.3F, -0.4F), .intensity = Rgb(0.3F)});
  const Lights table(scene, {}, 1000);
  const Lights tree(scene, {}, 0);
  Pcg32 random(12);
  for (int i = 0; i < 30; ++i) {
    const double half = i % 2 == 0 ? 1.0 : 3.0;
    const double x = half * (2.0 * random.uniform() - 1.0);
    const double y = half * (2.0 * random.uniform() - 1.0);
    const double z = half * (2.0 * random.uniform() - 1.0);
    const MeanEstimate by_table = irradiance_at(table, Vec3(x, y, z), 10000);
    const MeanEstimate by_tree = irradiance_at(tree, Vec3(x, y, z), 10000);
    EXPECT_NEAR(by_table.mean(), by_tree.mean(),
                5.0 * std::hypot(by_table.standard_error(), by_tree.standard_error()))
        << x << ' ' << y << ' ' << z;
  }
}

/// Turned, stretched, moved, and mirrored if asked to be.
Mat4 placement(bool mirrored) {
  return {{mirrored ? -1.2F : 1.2F, 0.1F, 0.3F, 0.0F},
          {0.0F, 0.8F, -0.2F, 0.0F},
          {0.4F, 0.0F, 1.5F, 0.0F},
          {0.3F, 1.7F, -0.4F, 1.0F}};
}

/// The mesh as the instance shows it. Mirroring turns the corners' order around (glTF 2.0, section
/// 3.7.4), so that the front stays the front.
Mesh baked(Mesh mesh, const Mat4& world_from_local) {
  for (Vec3& position : mesh.positions) {
    position = Vec3(world_from_local * Vec4(position, 1.0F));
  }
  if (glm::determinant(world_from_local) < 0.0F) {
    for (auto& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  mesh.normals.clear();
  return mesh;
}

TEST(LightsTest, InstancesShineAsIfTheyWereBaked) {
  for (const bool mirrored : {false, true}) {
    Scene instanced;
    instanced.materials = {emitter(2.0F)};
    instanced.prototypes = {quad(Vec3(-0.5F, 0, -0.5F), Vec3(1, 0, 0), Vec3(0, 0, 1), 0),
                            inward_box(Vec3(0.0F), 0.2F, 0)};
    Scene world;
    world.materials = instanced.materials;
    for (std::uint32_t prototype = 0; prototype < 2; ++prototype) {
      const Mat4 where = placement(mirrored);
      instanced.instances.push_back({.prototype = prototype, .world_from_local = where});
      world.meshes.push_back(baked(instanced.prototypes[prototype], where));
    }
    for (const std::size_t max_in_table : {std::size_t{32}, std::size_t{0}}) {
      const Lights of_instances(instanced, {}, max_in_table);
      const Lights of_meshes(world, {}, max_in_table);
      for (const Vec3& position : {Vec3(0.0F), Vec3(1, 0.5F, -2), Vec3(0.3F, 1.6F, -0.4F)}) {
        const MeanEstimate expected = irradiance_at(of_meshes, position, 20000);
        const MeanEstimate estimate = irradiance_at(of_instances, position, 20000);
        EXPECT_NEAR(estimate.mean(), expected.mean(),
                    5.0 * std::hypot(estimate.standard_error(), expected.standard_error()));
      }
      EXPECT_GT(irradiance_at(of_instances, Vec3(0.0F), 2000).mean(), 0.01);
    }
  }
}

TEST(LightsTest, UnlitSurfacesShineButAreNotDrawn) {
  Scene scene = ceiling_light({1.0F, 1.0F});
  scene.materials[0].unlit = true;
  const Lights lights(scene);
  EXPECT_FALSE(lights.empty());
  EXPECT_FALSE(lights.sample({.position = Vec3(0.0F)}, 0.5F, Vec2(0.5F), Vec2(0.5F)));
  const Hit hit{.t = 2.0F, .barycentric = {}, .object = 0, .triangle = 0};
  EXPECT_EQ(lights.triangle_pdf({.position = Vec3(0.0F)}, hit, 2.0F, 1.0F), 0.0F);
}

/// ShadingPoints at corners, on edges, in the plane and just off it, and far away; at all scales.
TEST(LightsTest, EverySampleIsFinite) {
  constexpr float largest = 1.0F - 0x1p-24F;
  for (const float scale : {1e-3F, 1.0F, 1e6F}) {
    Scene scene;
    scene.materials = {emitter(3.0F, true)};
    scene.meshes = {quad(Vec3(0.0F), scale * Vec3(1, 0, 0), scale * Vec3(0, 0, 1), 0),
                    quad(Vec3(0.0F), scale * Vec3(1, 0, 0), scale * Vec3(1, 1e-6F, 0), 0),
                    quad(Vec3(0.0F), Vec3(0.0F), scale * Vec3(0, 1, 0), 0)};
    scene.lights = {{.position = Vec3(0.0F), .intensity = Rgb(1.0F)},
                    {.position = scale * Vec3(1, 0, 0), .intensity = Rgb(1.0F), .radius_m = scale}};
    for (const std::size_t max_in_table : {std::size_t{32}, std::size_t{0}}) {
      const Lights lights(scene, {}, max_in_table);
      for (const Vec3& place :
           {Vec3(0.0F), Vec3(1, 0, 1), Vec3(0.5F, 0, 0.5F), Vec3(0.3F, 0, 0.6F), Vec3(7, 0, -3),
            Vec3(0.3F, 1e-7F, 0.6F), Vec3(0.3F, -1e-3F, 0.6F), Vec3(0, 1e-20F, 0), Vec3(3e3F)}) {
        const ShadingPoint shading_point{.position = scale * place, .normal = Vec3(0, 1, 0)};
        for (const float x : {0.0F, 0.4F, 0.7F, largest}) {
          for (const float y : {0.0F, 0.5F, largest}) {
            const auto light = lights.sample(shading_point, x, {y, x}, {x, y});
            if (light) {
              EXPECT_TRUE(is_finite(light->direction) && is_finite(light->radiance));
              EXPECT_NEAR(glm::length(light->direction), 1.0, 1e-5);
              EXPECT_TRUE(light->pdf > 0.0F && std::isfinite(light->pdf));
            }
          }
        }
        for (const std::uint32_t object : {0U, 1U, 2U}) {
          for (const float cosine : {0.0F, 1e-30F, 1e-3F, 1.0F}) {
            for (const float distance : {0.0F, 1e-30F, scale, 1e9F * scale}) {
              const Hit hit{.t = distance, .barycentric = {}, .object = object, .triangle = 0};
              const float pdf = lights.triangle_pdf(shading_point, hit, distance, cosine);
              EXPECT_TRUE(pdf >= 0.0F && std::isfinite(pdf));
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace foveola
