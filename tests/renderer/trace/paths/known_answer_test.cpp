// Scenes whose radiance is known: furnaces, planes and lights, by closed forms and quadrature.
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/trace/lights/environment_light.h"
#include "renderer/trace/lights/lights.h"
#include "renderer/trace/materials/bsdf.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/trace/surfaces/surface.h"
#include "tests/renderer/trace/paths.h"
#include "tests/renderer/trace/reference_bsdf.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/shadow_answers.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

using std::numbers::pi;

/// A closed sphere that shines 0.5 and reflects all light: each vertex adds 0.5.
TEST(KnownAnswerTest, WhiteFurnaceIsTheGeometricSeries) {
  Scene scene;
  scene.materials = {dielectric(1.0F)};
  scene.materials[0].emission = Rgb(0.5F);
  scene.meshes = {inward_sphere(1.0F, 5, 0)};
  const PathTracer tracer(scene, workers());
  for (const int max_depth : {1, 3, 12}) {
    const auto radiance = trace(tracer, Vec3(0.0F), jobs_all_around(20000), max_depth);
    expect_mean(mean_of(radiance), 0.5 * (max_depth + 1), 2e-3);
  }
}

/// The radiance inside a closed sphere that shines with radiance 1, by quadrature. In a sphere a
/// chord makes the same angle at both of its ends, so that radiance depends on that angle only.
double sphere_radiance(const ReferenceMaterial& material, int max_depth) {
  constexpr int cosines = 100;
  constexpr int azimuths = 64;
  const ReferenceCoat coat(material.alpha());
  const auto cosine_at = [](int i) { return (i + 0.5) / cosines; };
  const auto reflected = [&](double cosine, const std::vector<double>& incoming) {
    const DVec3 o(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    double sum = 0.0;
    for (int i = 0; i < cosines; ++i) {
      const double c = cosine_at(i);
      const double s = std::sqrt(1.0 - c * c);
      for (int k = 0; k < azimuths; ++k) {
        const double azimuth = pi * (k + 0.5) / azimuths;
        const DVec3 w(s * std::cos(azimuth), s * std::sin(azimuth), c);
        sum += reference_bsdf(material, coat, o, w) * c * incoming[static_cast<std::size_t>(i)];
      }
    }
    return sum * 2.0 * pi / (cosines * azimuths);
  };
  std::vector<double> radiance(cosines, 1.0);
  for (int depth = 1; depth < max_depth; ++depth) {
    std::vector<double> next;
    for (int i = 0; i < cosines; ++i) {
      next.push_back(1.0 + reflected(cosine_at(i), radiance));
    }
    radiance = next;
  }
  return 1.0 + reflected(1.0, radiance);
}

TEST(KnownAnswerTest, GreyFurnaceIsItsQuadrature) {
  for (const ReferenceMaterial& material :
       {ReferenceMaterial{0.5, 0.0, 1.0}, ReferenceMaterial{0.7, 1.0, 0.6}}) {
    Scene scene;
    scene.materials = {
        dielectric(static_cast<float>(material.base), static_cast<float>(material.roughness))};
    scene.materials[0].metallic = static_cast<float>(material.metallic);
    scene.materials[0].emission = Rgb(1.0F);
    scene.meshes = {inward_sphere(1.0F, 5, 0)};
    const PathTracer tracer(scene, workers());
    for (const int max_depth : {1, 3}) {
      const auto radiance = trace(tracer, Vec3(0.0F), jobs_all_around(20000), max_depth);
      expect_mean(mean_of(radiance), sphere_radiance(material, max_depth), 2e-3);
    }
  }
}

TEST(KnownAnswerTest, PlaneUnderAConstantSkyShowsItsAlbedo) {
  for (const double roughness : {0.1, 0.4, 1.0}) {
    for (const double metallic : {0.0, 1.0}) {
      for (const double cosine : {0.95, 0.3}) {
        const ReferenceMaterial material{1.0, metallic, roughness};
        Scene scene;
        scene.materials = {dielectric(1.0F, static_cast<float>(roughness))};
        scene.materials[0].metallic = static_cast<float>(metallic);
        scene.meshes = {quad(Vec3(-50, -1, 50), Vec3(100, 0, 0), Vec3(0, 0, -100), 0)};
        scene.environment = constant_environment(1.0F);
        const Vec3 direction(std::sqrt(1.0 - cosine * cosine), -cosine, 0.0);
        const MeanEstimate radiance = mean_radiance(scene, Vec3(0.0F), direction, 1, 10000);
        expect_mean(radiance, reference_albedo(material, cosine), 1.5e-3);
        EXPECT_LE(radiance.mean(), 1.001 + 5.0 * radiance.standard_error());
      }
    }
  }
}

/// A floor at y = 0 under a rectangle of radiance 5 at y = 1, |x| < 0.5, |z| < 1, seen from
/// (-1, 1, 0) where the ray meets the floor at the origin.
Scene floor_and_light(const Material& material) {
  Scene scene;
  scene.materials = {material, emitter(5.0F)};
  scene.meshes = {quad(Vec3(-9, 0, 9), Vec3(18, 0, 0), Vec3(0, 0, -18), 0),
                  quad(Vec3(-0.5F, 1, -1), Vec3(1, 0, 0), Vec3(0, 0, 2), 1)};
  return scene;
}

/// lamp: what the light shines with at a cosine to its normal, in units of 5.
double floor_radiance(
    const ReferenceMaterial& material,
    const std::function<double(double)>& lamp = [](double) { return 1.0; }) {
  const ReferenceCoat coat(material.alpha());
  const double a = std::sqrt(0.5);
  constexpr int steps = 800;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      // Local coordinates, whose z is the floor's normal.
      const DVec3 to((i + 0.5) / steps - 0.5, 2.0 * (k + 0.5) / steps - 1.0, 1.0);
      const double squared = glm::dot(to, to);
      const DVec3 w = to / std::sqrt(squared);
      sum += reference_bsdf(material, coat, DVec3(-a, 0.0, a), w) * w.z * w.z / squared * lamp(w.z);
    }
  }
  return 5.0 * 2.0 * sum / (steps * steps);
}

TEST(KnownAnswerTest, DirectLightOfARectangleIsItsQuadrature) {
  for (const ReferenceMaterial& material :
       {ReferenceMaterial{0.8, 0.0, 1.0}, ReferenceMaterial{0.8, 0.5, 0.5},
        ReferenceMaterial{0.9, 1.0, 0.2}}) {
    Material floor =
        dielectric(static_cast<float>(material.base), static_cast<float>(material.roughness));
    floor.metallic = static_cast<float>(material.metallic);
    const MeanEstimate radiance =
        mean_radiance(floor_and_light(floor), Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 40000);
    expect_mean(radiance, floor_radiance(material), 1.5e-3, 0.015);
  }
}

/// As much as a camera sees of it: Schlick's F of the coat is missing in each direction.
TEST(KnownAnswerTest, ACoatedLampLightsByWhatItsCoatLetsThrough) {
  const auto lamp = [](double cosine) { return 1.0 - (0.04 + 0.96 * std::pow(1.0 - cosine, 5.0)); };
  Scene scene = floor_and_light(dielectric(0.8F));
  scene.materials[1].clearcoat = 1.0F;
  const MeanEstimate radiance = mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 40000);
  expect_mean(radiance, floor_radiance({0.8, 0.0, 1.0}, lamp), 1.5e-3);
}

/// A smooth coat over a black base whose normal map leans by some 20 degrees; lamps of radiance 1
/// straight above, and where a mirror that leans as the map would show one.
TEST(KnownAnswerTest, AClearCoatMirrorsAboutItsOwnNormal) {
  const std::vector<std::uint8_t> texel{171, 128, 247, 255};
  const Vec3 leaning = glm::normalize(2.0F * Vec3(texel[0], texel[2], 0) / 255.0F - Vec3(1, 1, 0));
  const Vec3 aside = glm::reflect(Vec3(0, -1, 0), leaning);
  const auto shown = [&](const Vec3& to_lamp, bool coat_is_mapped) {
    Scene scene;
    scene.materials = {matte(Rgb(0.0F)), lamp(Rgb(1.0F), true)};
    scene.materials[0].clearcoat = 1.0F;
    (coat_is_mapped ? scene.materials[0].clearcoat_normal_texture
                    : scene.materials[0].normal_texture)
        .texture = 0;
    scene.textures.emplace_back(1, 1, texel, false, Wrap::repeat, Wrap::repeat);
    const Frame frame(to_lamp);
    const Vec3 across = 2.0F * frame.tangent;
    const Vec3 along = 2.0F * frame.bitangent;
    scene.meshes = {quad(Vec3(-1, 0, 1), Vec3(2, 0, 0), Vec3(0, 0, -2), 0),
                    quad(10.0F * to_lamp - 0.5F * (across + along), across, along, 1)};
    scene.meshes[0].tangents.assign(4, Vec4(1, 0, 0, 1));
    return mean_radiance(scene, Vec3(0, 5, 0), Vec3(0, -1, 0), 2, 1000).mean();
  };
  EXPECT_NEAR(shown(Vec3(0, 1, 0), false), 0.04, 1e-5);
  EXPECT_EQ(shown(aside, false), 0.0);
  EXPECT_EQ(shown(Vec3(0, 1, 0), true), 0.0);
  EXPECT_NEAR(shown(aside, true), 0.04 + 0.96 * std::pow(1.0 - leaning.y, 5.0), 1e-5);
}

/// The image environment through the whole estimator: a bright square of sky 40 times the rest.
TEST(KnownAnswerTest, DirectLightOfAnImageIsItsQuadrature) {
  constexpr int width = 64;
  constexpr int height = 32;
  Scene scene;
  scene.materials = {dielectric(0.6F, 0.5F)};
  scene.meshes = {quad(Vec3(-9, 0, 9), Vec3(18, 0, 0), Vec3(0, 0, -18), 0)};
  Environment sky = constant_environment(1.0F);
  sky.map_width = width;
  sky.map_height = height;
  sky.map.assign(width * height, Rgb(0.5F));
  for (std::size_t y = 8; y < 12; ++y) {
    for (std::size_t x = 30; x < 36; ++x) {
      sky.map[y * width + x] = Rgb(20.0F);
    }
  }
  scene.environment = sky;
  const EnvironmentLight light(sky);
  const ReferenceMaterial material{0.6, 0.0, 0.5};
  const ReferenceCoat coat(material.alpha());
  const double a = std::sqrt(0.5);
  double expected = 0.0;
  constexpr int rings = 300;
  constexpr int sectors = 600;
  for (int i = 0; i < rings; ++i) {
    const double up = (i + 0.5) / rings;
    const double horizontal = std::sqrt(1.0 - up * up);
    for (int k = 0; k < sectors; ++k) {
      const double azimuth = 2.0 * pi * (k + 0.5) / sectors;
      const DVec3 w(horizontal * std::cos(azimuth), up, horizontal * std::sin(azimuth));
      // Local coordinates of the floor: x, -z, y.
      expected += reference_bsdf(material, coat, DVec3(-a, 0.0, a), DVec3(w.x, -w.z, w.y)) * up *
                  light.at(Vec3(w)).radiance.g * 2.0 * pi / (rings * sectors);
    }
  }
  expect_mean(mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 40000), expected, 2e-3);
}

/// Each strategy alone, without weights, on the scene of floor_and_light.
MeanEstimate one_strategy(const Scene& scene, bool sample_lights, int samples) {
  const RayScene rays(scene, workers());
  const Lights lights(scene);
  const ScatteringTables tables(scene.materials, workers());
  const Vec3 direction = glm::normalize(Vec3(1, -1, 0));
  const Hit hit = rays.closest_hit(Vec3(-1, 1, 0), direction);
  const SurfacePoint point = surface_point(scene, hit, direction);
  const Frame frame(point.shading_normal);
  const Bsdf bsdf(point.reflectance, frame.to_local(-direction), tables);
  const auto from_light = [&](SampleStream& random) -> double {
    const Vec2 choice = random.next_2d();
    const ShadingPoint shading_point{
        .position = point.origin, .normal = point.geometric_normal, .transmits = false};
    const auto light = lights.sample(shading_point, 0.0F, choice, random.next_2d());
    if (!light) {
      return 0.0;
    }
    Ray shadow{.origin = point.origin, .direction = light->to_light};
    shadow.t_max = light->t_max;
    const bool is_blocked = test::ask_blocked(rays, {&shadow, 1})[0].is_blocked;
    const BsdfValue value = bsdf.eval(frame.to_local(light->direction));
    return is_blocked ? 0.0 : value.times_cosine.g * light->radiance.g / light->pdf;
  };
  const auto from_bsdf = [&](SampleStream& random) -> double {
    const float lobe = random.next_1d();
    const auto sample = bsdf.sample(lobe, random.next_2d());
    if (!sample) {
      return 0.0;
    }
    const Vec3 world = frame.to_world(sample->incoming);
    const Hit next = rays.closest_hit(point.origin, world);
    return next.missed() ? 0.0 : sample->weight.g * surface_emission(scene, next, world).radiance.g;
  };
  MeanEstimate estimate;
  for (int i = 0; i < samples; ++i) {
    SampleStream random(9, 0, static_cast<std::uint32_t>(i));
    estimate.add(sample_lights ? from_light(random) : from_bsdf(random));
  }
  return estimate;
}

TEST(KnownAnswerTest, BothStrategiesAndTheirCombinationAgree) {
  const Scene scene = floor_and_light(metal(0.9F, 0.5F));
  const MeanEstimate combined = mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 40000);
  const MeanEstimate lights = one_strategy(scene, true, 40000);
  const MeanEstimate bsdf = one_strategy(scene, false, 40000);
  for (const MeanEstimate& alone : {lights, bsdf}) {
    EXPECT_NEAR(alone.mean(), combined.mean(),
                5.0 * std::hypot(alone.standard_error(), combined.standard_error()));
    EXPECT_LT(combined.standard_error(), 1.1 * alone.standard_error());
  }
}

/// Boxes of index 1, which neither reflect nor bend, that leave half and a tenth of light after a
/// metre, under a sky of radiance 1.
TEST(KnownAnswerTest, ACameraInASolidIsAbsorbedFromItsFirstMetre) {
  const auto absorbing = [](float left_after_a_metre) {
    Material material = matte(Rgb(1.0F));
    material.ior = 1.0F;
    material.transmission = 1.0F;
    material.is_solid = true;
    material.attenuation_color = Rgb(left_after_a_metre);
    material.attenuation_distance_m = 1.0F;
    return material;
  };
  Scene scene;
  scene.materials = {absorbing(0.5F), absorbing(0.1F)};
  scene.meshes = {inside_out(inward_box(Vec3(0.0F), 2.0F, 0))};
  scene.environment = constant_environment(1.0F);
  const auto radiance = [&](const Vec3& viewpoint) {
    Rgb arriving;
    PathTracer(scene, workers())
        .trace(viewpoint, jobs_along(Vec3(1, 0, 0), 1), {&arriving, 1},
               {.vertices_before_roulette = no_roulette}, workers());
    return arriving.g;
  };
  EXPECT_NEAR(radiance(Vec3(0, 0.3F, 0.2F)), 0.25, 1e-4);
  EXPECT_NEAR(radiance(Vec3(1.5F, 0.3F, 0.2F)), std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(radiance(Vec3(-5, 0.3F, 0.2F)), 0.0625, 1e-4);
  EXPECT_NEAR(radiance(Vec3(5, 0.3F, 0.2F)), 1.0, 1e-6);
  scene.meshes.push_back(inside_out(inward_box(Vec3(0.0F), 0.5F, 1)));
  EXPECT_NEAR(radiance(Vec3(0, 0.3F, 0.2F)), std::sqrt(0.1), 1e-4) << "outside of each is air";
  EXPECT_NEAR(radiance(Vec3(1.5F, 0.3F, 0.2F)), std::sqrt(0.5), 1e-4);
}

/// The share of the places on a ball under a sun that are darker than a fifth of the cosine of the
/// smooth normal, where that is 0.05 to 0.6.
double share_of_black_places(const Mesh& ball, bool general_path) {
  constexpr double ball_albedo = 0.8;
  constexpr std::uint32_t side = 256;
  const Vec3 to_sun = glm::normalize(Vec3(1.0F, 0.4F, -0.3F));
  Scene scene;
  scene.materials = {matte(Rgb(static_cast<float>(ball_albedo)))};
  scene.meshes = {ball};
  scene.lights = {{.name = "",
                   .kind = PunctualLight::Kind::directional,
                   .direction = -to_sun,
                   .intensity = Rgb(std::numbers::pi_v<float>)}};
  const PathTracer tracer(scene, workers());
  const Vec3 viewpoint(0, 0, 5);
  std::vector<SampleJob> jobs;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const Vec2 place = (Vec2(i % side, i / side) + 0.5F) / static_cast<float>(side) - 0.5F;
    jobs.push_back({.direction = glm::normalize(Vec3(0.45F * place, -1.0F)), .pixel = i});
  }
  std::vector<Rgb> radiance(jobs.size());
  tracer.trace(viewpoint, jobs, radiance, {.max_depth = 1, .uses_general_path = general_path},
               workers());
  int places = 0;
  int black = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Hit hit = tracer.ray_scene().closest_hit(viewpoint, jobs[i].direction);
    if (hit.missed()) {
      continue;
    }
    const SurfacePoint point = surface_point(scene, hit, jobs[i].direction);
    const double cosine = glm::dot(point.shading_normal, to_sun);
    if (cosine > 0.05 && cosine < 0.6) {
      ++places;
      black += radiance[i].g < 0.2 * ball_albedo * cosine ? 1 : 0;
    }
  }
  EXPECT_GT(places, 3000);
  return static_cast<double>(black) / places;
}

// Of a ball of 320 triangles 3 % were black, in a staircase along the terminator; Cycles has 0.18
// %.
TEST(KnownAnswerTest, SmoothBallsOfFewTrianglesHaveNoStaircase) {
  const Mesh ball = inside_out(inward_sphere(1.0F, 2, 0));
  for (const bool general_path : {false, true}) {
    EXPECT_LE(share_of_black_places(ball, general_path), 0.003);
    EXPECT_EQ(share_of_black_places(flat_shaded(ball), general_path), 0.0);
  }
}

/// A lamp behind a sheet whose left half (x < 0) is cut out, and a floor beyond.
TEST(KnownAnswerTest, LightPassesThroughCutOuts) {
  Scene scene = floor_and_light(dielectric(0.8F));
  const double open = mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 20000).mean();
  scene.materials.push_back(dielectric(0.0F));
  scene.materials[2].base_color_texture.texture = 0;
  scene.materials[2].alpha_mode = AlphaMode::mask;
  scene.textures.emplace_back(1, 1, std::vector<std::uint8_t>{255, 255, 255, 0}, true, Wrap::repeat,
                              Wrap::repeat);
  scene.meshes.push_back(quad(Vec3(-5, 0.5F, 5), Vec3(10, 0, 0), Vec3(0, 0, -10), 2));
  EXPECT_EQ(mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 20000).mean(), open);
  scene.materials[2].alpha_mode = AlphaMode::opaque;
  EXPECT_EQ(mean_radiance(scene, Vec3(-1, 0.4F, 0), Vec3(1, -0.4F, 0), 1, 2000).mean(), 0.0);
}

TEST(KnownAnswerTest, CutOutsOfAnEmitterDoNotShine) {
  Scene scene = floor_and_light(dielectric(0.8F));
  scene.materials[1].base_color_texture.texture = 0;
  scene.materials[1].alpha_mode = AlphaMode::mask;
  // The light's two halves along z: a hole and solid.
  scene.textures.emplace_back(1, 2, std::vector<std::uint8_t>{255, 255, 255, 0, 0, 0, 0, 255}, true,
                              Wrap::clamp_to_edge, Wrap::clamp_to_edge);
  const MeanEstimate half = mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 40000);
  expect_mean(half, 0.5 * floor_radiance({0.8, 0.0, 1.0}), 2e-3);
}

}  // namespace
}  // namespace foveola
