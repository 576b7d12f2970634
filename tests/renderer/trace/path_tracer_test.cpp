#include "renderer/trace/path_tracer.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "reference_bsdf.h"
#include "renderer/base/random.h"
#include "renderer/trace/bsdf.h"
#include "renderer/trace/environment_light.h"
#include "renderer/trace/lights.h"
#include "renderer/trace/ray_scene.h"
#include "renderer/trace/surface.h"
#include "scenes.h"
#include "statistics.h"

namespace foveola {
namespace {

constexpr double pi = std::numbers::pi;

const Workers& workers() {
  static const Workers four(4);
  return four;
}

std::vector<SampleJob> jobs_along(const Vec3& direction, std::uint32_t count) {
  std::vector<SampleJob> jobs;
  for (std::uint32_t i = 0; i < count; ++i) {
    jobs.push_back({.direction = glm::normalize(direction), .pixel = i, .sample_number = 0});
  }
  return jobs;
}

std::vector<SampleJob> jobs_all_around(std::uint32_t count) {
  std::vector<SampleJob> jobs;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec2 u = sobol_2d(i, 17);
    jobs.push_back({.direction = direction_from({.azimuth_rad = 2.0 * pi * u.x,
                                                 .elevation_rad = std::asin(2.0 * u.y - 1.0)}),
                    .pixel = i % 100,
                    .sample_number = i / 100});
  }
  return jobs;
}

std::vector<Rgb> trace(const PathTracer& tracer, const Vec3& viewpoint,
                       const std::vector<SampleJob>& jobs, int max_depth) {
  std::vector<Rgb> radiance(jobs.size());
  tracer.trace(viewpoint, jobs, radiance, {.max_depth = max_depth, .seed = 1}, workers());
  return radiance;
}

MeanEstimate mean_of(const std::vector<Rgb>& radiance) {
  MeanEstimate mean;
  for (const Rgb& value : radiance) {
    mean.add(value.g);
  }
  return mean;
}

MeanEstimate mean_radiance(const Scene& scene, const Vec3& viewpoint, const Vec3& direction,
                           int max_depth, std::uint32_t samples) {
  return mean_of(
      trace(PathTracer(scene, workers()), viewpoint, jobs_along(direction, samples), max_depth));
}

TEST(PathTracerTest, EmptySceneIsBlackWithoutTracing) {
  const Scene scene;
  const std::vector<SampleJob> jobs = jobs_all_around(1000);
  std::vector<Rgb> radiance(jobs.size(), Rgb(7.0F));
  const RayCounts rays =
      PathTracer(scene, workers()).trace(Vec3(0.0F), jobs, radiance, {}, workers());
  EXPECT_EQ(rays.total(), 0U);
  for (const Rgb& value : radiance) {
    EXPECT_EQ(value, Rgb(0.0F));
  }
}

TEST(PathTracerTest, WithoutGeometryTheEnvironmentIsSeen) {
  Scene scene;
  scene.environment = constant_environment(0.75F);
  for (const Rgb& value :
       trace(PathTracer(scene, workers()), Vec3(0.0F), jobs_all_around(1000), 4)) {
    EXPECT_EQ(value, Rgb(0.75F));
  }
}

TEST(PathTracerTest, EmittersAreSeenDirectlyAtAnyDepth) {
  Scene scene;
  scene.materials = {emitter(3.0F)};
  scene.meshes = {quad(Vec3(-1, -1, -2), Vec3(2, 0, 0), Vec3(0, 2, 0), 0)};
  const PathTracer tracer(scene, workers());
  for (const int max_depth : {0, 1, 5}) {
    for (const Rgb& value : trace(tracer, Vec3(0.0F), jobs_along({0, 0, -1}, 100), max_depth)) {
      EXPECT_EQ(value, Rgb(3.0F));
    }
  }
  // From behind, a single-sided emitter is black: nothing else shines here.
  for (const Rgb& value : trace(tracer, Vec3(0, 0, -4), jobs_along({0, 0, 1}, 100), 5)) {
    EXPECT_EQ(value, Rgb(0.0F));
  }
}

TEST(PathTracerTest, CountsRaysByKind) {
  Scene scene;
  scene.materials = {dielectric(0.5F), emitter(1.0F)};
  scene.meshes = {quad(Vec3(-50, -1, 50), Vec3(100, 0, 0), Vec3(0, 0, -100), 0),
                  quad(Vec3(-50, 1, -50), Vec3(100, 0, 0), Vec3(0, 0, 100), 1)};
  const std::vector<SampleJob> jobs = jobs_along({0, -1, 0}, 1000);
  std::vector<Rgb> radiance(jobs.size());
  const RayCounts rays =
      PathTracer(scene, workers()).trace(Vec3(0.0F), jobs, radiance, {.max_depth = 1}, workers());
  EXPECT_EQ(rays.primary, 1000U);
  EXPECT_EQ(rays.shadow, 1000U);
  EXPECT_NEAR(static_cast<double>(rays.bounce), 1000.0, 20.0);  // but for samples below the floor
}

/// A closed sphere that shines 0.5 and reflects all light: each vertex adds 0.5.
TEST(PathTracerTest, WhiteFurnaceIsTheGeometricSeries) {
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

TEST(PathTracerTest, GreyFurnaceIsItsQuadrature) {
  for (const ReferenceMaterial material :
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

TEST(PathTracerTest, PlaneUnderAConstantSkyShowsItsAlbedo) {
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

double floor_radiance(const ReferenceMaterial& material) {
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
      sum += reference_bsdf(material, coat, DVec3(-a, 0.0, a), w) * w.z * w.z / squared;
    }
  }
  return 5.0 * 2.0 * sum / (steps * steps);
}

TEST(PathTracerTest, DirectLightOfARectangleIsItsQuadrature) {
  for (const ReferenceMaterial material :
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

/// The image environment through the whole estimator: a bright square of sky 40 times the rest.
TEST(PathTracerTest, DirectLightOfAnImageIsItsQuadrature) {
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
                  light.radiance(Vec3(w)).g * 2.0 * pi / (rings * sectors);
    }
  }
  expect_mean(mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 40000), expected, 2e-3);
}

/// Each strategy alone, without weights, on the scene of floor_and_light.
MeanEstimate one_strategy(const Scene& scene, bool sample_lights, int samples) {
  const RayScene rays(scene, workers());
  const Lights lights(scene);
  const CoatAlbedo coat(workers());
  const Vec3 direction = glm::normalize(Vec3(1, -1, 0));
  const Hit hit = rays.closest_hit(Vec3(-1, 1, 0), direction);
  const SurfacePoint point = surface_point(scene, hit, direction);
  const Frame frame(point.shading_normal);
  const Bsdf bsdf(point.reflectance, frame.to_local(-direction), coat);
  const auto from_light = [&](SampleStream& random) -> double {
    const Vec2 choice = random.next_2d();
    const auto light = lights.sample(point.origin, 0.0F, choice, random.next_2d());
    if (!light) {
      return 0.0;
    }
    Ray shadow = light->shadow_ray;
    rays.find_blocked({&shadow, 1});
    const BsdfValue value = bsdf.eval(frame.to_local(light->direction));
    return shadow.is_blocked() ? 0.0 : value.times_cosine.g * light->radiance.g / light->pdf;
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

TEST(PathTracerTest, BothStrategiesAndTheirCombinationAgree) {
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

/// A lamp behind a sheet whose left half (x < 0) is cut out, and a floor beyond.
TEST(PathTracerTest, LightPassesThroughCutOuts) {
  Scene scene = floor_and_light(dielectric(0.8F));
  const double open = mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 20000).mean();
  scene.materials.push_back(dielectric(0.0F));
  scene.materials[2].base_color_texture = 0;
  scene.materials[2].alpha_cutoff = 0.5F;
  scene.textures.emplace_back(1, 1, std::vector<std::uint8_t>{255, 255, 255, 0}, true, Wrap::repeat,
                              Wrap::repeat);
  scene.meshes.push_back(quad(Vec3(-5, 0.5F, 5), Vec3(10, 0, 0), Vec3(0, 0, -10), 2));
  EXPECT_EQ(mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 20000).mean(), open);
  scene.materials[2].alpha_cutoff = 0.0F;
  EXPECT_EQ(mean_radiance(scene, Vec3(-1, 0.4F, 0), Vec3(1, -0.4F, 0), 1, 2000).mean(), 0.0);
}

TEST(PathTracerTest, HolesOfAnEmitterDoNotShine) {
  Scene scene = floor_and_light(dielectric(0.8F));
  scene.materials[1].base_color_texture = 0;
  scene.materials[1].alpha_cutoff = 0.5F;
  // The light's two halves along z: a hole and solid.
  scene.textures.emplace_back(1, 2, std::vector<std::uint8_t>{255, 255, 255, 0, 0, 0, 0, 255}, true,
                              Wrap::clamp_to_edge, Wrap::clamp_to_edge);
  const MeanEstimate half = mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, 40000);
  expect_mean(half, 0.5 * floor_radiance({0.8, 0.0, 1.0}), 2e-3);
}

/// Emitters of different sizes, glossy walls, a box with overlapping faces, an environment.
Scene busy_scene() {
  Scene scene;
  scene.materials = {dielectric(0.7F), metal(0.8F, 0.3F), emitter(8.0F), emitter(2.0F, true)};
  scene.meshes = {inward_box(Vec3(0.0F), 2.0F, 0), inward_sphere(0.5F, 3, 1),
                  quad(Vec3(-0.5F, 1.99F, -0.5F), Vec3(1, 0, 0), Vec3(0, 0, 1), 2),
                  quad(Vec3(-1.5F, -1, -1.5F), Vec3(0.4F, 0, 0), Vec3(0, 0.4F, 0), 3),
                  quad(Vec3(-1, -2, 1), Vec3(2, 0, 0), Vec3(0, 0, -2), 1)};
  for (Vec3& position : scene.meshes[1].positions) {
    position += Vec3(0.8F, -0.5F, -0.8F);
  }
  scene.meshes[0].triangles.pop_back();
  scene.environment = constant_environment(0.3F);
  return scene;
}

TEST(PathTracerTest, RadianceDependsOnTheJobAlone) {
  const Scene scene = busy_scene();
  const Vec3 viewpoint(0.1F, 0.2F, 1.5F);
  const std::vector<SampleJob> jobs = jobs_all_around(5000);
  const std::vector<Rgb> expected = trace(PathTracer(scene, workers()), viewpoint, jobs, 6);
  EXPECT_GT(mean_of(expected).mean(), 0.1);

  for (const int threads : {1, 2}) {
    const Workers others(threads);
    std::vector<Rgb> radiance(jobs.size());
    PathTracer(scene, others).trace(viewpoint, jobs, radiance, {.max_depth = 6, .seed = 1}, others);
    EXPECT_EQ(radiance, expected) << threads << " threads";
  }
  const PathTracer tracer(scene, workers());
  std::vector<std::size_t> order(jobs.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  Pcg32 random(3);
  shuffle(std::span(order), random);
  std::vector<SampleJob> shuffled;
  for (const std::size_t i : order) {
    shuffled.push_back(jobs[i]);
  }
  const std::vector<Rgb> radiance = trace(tracer, viewpoint, shuffled, 6);
  for (std::size_t i = 0; i < order.size(); ++i) {
    ASSERT_EQ(radiance[i], expected[order[i]]) << "shuffled, job " << order[i];
  }
  for (std::size_t begin = 0; begin < jobs.size(); begin += 777) {
    const std::size_t end = std::min(jobs.size(), begin + 777);
    const std::vector<SampleJob> part(jobs.begin() + static_cast<std::ptrdiff_t>(begin),
                                      jobs.begin() + static_cast<std::ptrdiff_t>(end));
    const std::vector<Rgb> values = trace(tracer, viewpoint, part, 6);
    for (std::size_t i = 0; i < part.size(); ++i) {
      ASSERT_EQ(values[i], expected[begin + i]) << "split, job " << begin + i;
    }
  }
}

TEST(PathTracerTest, SeedPixelAndSampleNumberGiveOtherPaths) {
  const Scene scene = busy_scene();
  const PathTracer tracer(scene, workers());
  const SampleJob job{.direction = glm::normalize(Vec3(1, -1, -1)), .pixel = 5, .sample_number = 3};
  const auto radiance_of = [&](const SampleJob& other, std::uint32_t seed) {
    std::vector<Rgb> radiance(1);
    tracer.trace(Vec3(0.0F), {&other, 1}, radiance, {.max_depth = 6, .seed = seed}, workers());
    return radiance[0];
  };
  const Rgb reference = radiance_of(job, 1);
  EXPECT_EQ(radiance_of(job, 1), reference);
  EXPECT_NE(radiance_of(job, 2), reference);
  EXPECT_NE(radiance_of({job.direction, 6, 3}, 1), reference);
  EXPECT_NE(radiance_of({job.direction, 5, 4}, 1), reference);
}

/// A closed box with a bright sky and a lamp outside, turned and moved: black inside, whatever its
/// size.
TEST(PathTracerTest, NoLightLeaksIntoAClosedBox) {
  for (const float scale : {1e-3F, 1.0F, 1e3F}) {
    for (const Vec3& place : {Vec3(0.0F), Vec3(30.0F, -20.0F, 10.0F)}) {
      Scene scene;
      scene.materials = {dielectric(1.0F, 0.5F), emitter(1e6F, true)};
      scene.meshes = {inward_box(Vec3(0.0F), 1.0F, 0),
                      quad(Vec3(-9, 3, -9), Vec3(18, 0, 0), Vec3(0, 0, 18), 1)};
      const Quat turn = glm::angleAxis(0.7F, glm::normalize(Vec3(1, 2, -1)));
      for (Mesh& mesh : scene.meshes) {
        for (Vec3& position : mesh.positions) {
          position = scale * (turn * position + place);
        }
      }
      scene.environment = constant_environment(1e6F);
      const auto radiance = trace(PathTracer(scene, workers()), scale * (place + Vec3(0.2F)),
                                  jobs_all_around(50000), 8);
      int leaks = 0;
      for (const Rgb& value : radiance) {
        leaks += value == Rgb(0.0F) ? 0 : 1;
      }
      EXPECT_EQ(leaks, 0) << scale << ' ' << place.x;
    }
  }
}

/// Acne would darken a plane under a sky of radiance 1, whose radiance does not depend on scale.
TEST(PathTracerTest, PlanesDoNotShadowThemselves) {
  for (const float scale : {1e-3F, 1.0F, 1e3F}) {
    Scene scene;
    scene.materials = {dielectric(1.0F)};
    scene.meshes = {quad(Vec3(-9, 0, 9), Vec3(18, 0.7F, 0), Vec3(0, 0.3F, -18), 0)};
    for (Vec3& position : scene.meshes[0].positions) {
      position = scale * (position + Vec3(1.7F, 2.9F, -11.3F));
    }
    scene.environment = constant_environment(1.0F);
    const PathTracer tracer(scene, workers());
    const Vec3 above = scale * (Vec3(1.7F, 3.9F, -11.3F) + Vec3(0.0F, 1.0F, 0.0F));
    std::vector<Rgb> radiance(20000);
    const auto jobs = jobs_along({0.3F, -1.0F, 0.2F}, 20000);
    tracer.trace(above, jobs, radiance, {.max_depth = 1}, workers());
    expect_mean(mean_of(radiance), 1.0, 1e-3);
  }
}

TEST(PathTracerTest, PicksTheFirstSurface) {
  Scene scene;
  scene.materials = {dielectric(0.5F)};
  scene.meshes = {quad(Vec3(-1, -1, -5), Vec3(2, 0, 0), Vec3(0, 2, 0), 0),
                  quad(Vec3(-1, -1, -3), Vec3(2, 0, 0), Vec3(0, 2, 0), 0)};
  const PathTracer tracer(scene, workers());
  const auto picked = tracer.pick(Vec3(0.1F, 0.2F, 0.0F), Vec3(0, 0, -20));
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->mesh, 1U);
  EXPECT_FLOAT_EQ(picked->distance, 3.0F);
  EXPECT_NEAR(glm::length(picked->position - Vec3(0.1F, 0.2F, -3.0F)), 0.0, 1e-6);
  EXPECT_FALSE(tracer.pick(Vec3(0.0F), Vec3(0, 0, 1)));
  EXPECT_FALSE(tracer.pick(Vec3(0.0F), Vec3(0.0F)));
}

}  // namespace
}  // namespace foveola
