#include "renderer/trace/paths/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/renderer/trace/paths.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

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

TEST(PathTracerTest, TheLoggedRaysAreThoseThatWereTraced) {
  Scene scene = busy_scene();
  scene.materials.push_back(dielectric(0.9F));
  scene.materials.back().transmission = 1.0F;
  scene.materials.back().roughness = 0.0F;
  scene.meshes.push_back(quad(Vec3(-2, 0, -1), Vec3(4, 0, 0), Vec3(0, 0.2F, 2),
                              static_cast<int>(scene.materials.size()) - 1));
  const PathTracer tracer(scene, workers());
  const std::vector<SampleJob> jobs = jobs_all_around(3000);
  std::vector<Rgb> radiance(jobs.size());
  const TraceSettings settings{.max_depth = 5, .seed = 1};
  const RayCounts counts = tracer.trace(Vec3(0.0F), jobs, radiance, settings, workers());
  const RayLog log = tracer.log_rays(Vec3(0.0F), jobs, settings);
  EXPECT_EQ(log.primary.size(), counts.primary);
  EXPECT_EQ(log.bounce.size(), counts.bounce);
  EXPECT_EQ(log.shadow.size(), counts.shadow);
  EXPECT_EQ(log.transmittance.size(), counts.transmittance);
  EXPECT_GT(counts.transmittance, 0U);
  // A job's ray comes again behind each thin transmissive surface that it passes.
  std::size_t seen = 0;
  for (const Ray& ray : log.primary) {
    seen += seen < jobs.size() && ray.direction == jobs[seen].direction ? 1 : 0;
  }
  EXPECT_EQ(seen, jobs.size());
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
  EXPECT_EQ(picked->object, 1U);
  EXPECT_FLOAT_EQ(picked->distance_m, 3.0F);
  EXPECT_NEAR(glm::length(picked->position - Vec3(0.1F, 0.2F, -3.0F)), 0.0, 1e-6);
  EXPECT_FALSE(tracer.pick(Vec3(0.0F), Vec3(0, 0, 1)));
  EXPECT_FALSE(tracer.pick(Vec3(0.0F), Vec3(0.0F)));
}

TEST(PathTracerTest, AReplayedPathIsTheOneThatWasTraced) {
  const Scene scene = busy_scene();
  const PathTracer tracer(scene, workers());
  const Vec3 viewpoint(0.1F, 0.2F, 1.5F);
  const std::vector<SampleJob> jobs = jobs_all_around(300);
  const std::vector<Rgb> radiance = trace(tracer, viewpoint, jobs, 6);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const PathRecord record = tracer.replay(viewpoint, jobs[i], {.max_depth = 6, .seed = 1});
    EXPECT_EQ(record.radiance, radiance[i]) << i;
    ASSERT_FALSE(record.vertices.empty());
    EXPECT_EQ(record.vertices.front().direction, jobs[i].direction);
    EXPECT_LE(record.vertices.size(), 7U);
    for (std::size_t v = 1; v < record.vertices.size(); ++v) {
      const Vec3 step = record.vertices[v].distance_m * record.vertices[v].direction;
      if (record.vertices[v].object) {
        // A ray starts a little before the last hit, on the way there.
        const PathVertex& last = record.vertices[v - 1];
        const Vec3 before = last.position + step - record.vertices[v].position;
        const float back = std::max(0.0F, glm::dot(before, last.direction));
        EXPECT_LE(back, 0.5F * last.distance_m);
        EXPECT_NEAR(glm::length(before - back * last.direction), 0.0, 1e-4);
      }
    }
  }
}

/// Spheres around the viewer, one of them mirrored, all lit by an emitting one.
Scene scene_of_spheres(bool with_instances) {
  Scene scene;
  scene.materials = {dielectric(0.6F), emitter(50.0F)};
  Mesh lamp = inward_sphere(0.3F, 2, 1);
  for (auto& triangle : lamp.triangles) {
    std::swap(triangle[1], triangle[2]);  // shines outwards
  }
  scene.prototypes = {inward_sphere(0.8F, 3, 0), lamp};
  for (const float x : {-2.0F, 2.0F}) {
    Mat4 world_from_local(1.0F);
    world_from_local[0].x = x < 0.0F ? -1.0F : 1.0F;
    world_from_local[1].y = 1.5F;
    world_from_local[3] = Vec4(x, 0.2F, -1.0F, 1.0F);
    scene.instances.push_back(
        {.name = "ball", .prototype = 0, .world_from_local = world_from_local});
    world_from_local[3] += Vec4(0.0F, 1.9F, 0.0F, 0.0F);
    scene.instances.push_back(
        {.name = "lamp", .prototype = 1, .world_from_local = world_from_local});
  }
  if (!with_instances) {
    for (const Instance& instance : scene.instances) {
      Mesh mesh = scene.prototypes[instance.prototype];
      const Mat3 linear(instance.world_from_local);
      for (Vec3& position : mesh.positions) {
        position = Vec3(instance.world_from_local * Vec4(position, 1.0F));
      }
      for (Vec3& normal : mesh.normals) {
        normal = glm::normalize(glm::inverse(glm::transpose(linear)) * normal);
      }
      if (glm::determinant(linear) < 0.0F) {
        for (auto& triangle : mesh.triangles) {
          std::swap(triangle[1], triangle[2]);
        }
      }
      scene.meshes.push_back(mesh);
    }
    scene.prototypes.clear();
    scene.instances.clear();
  }
  return scene;
}

TEST(PathTracerTest, InstancesLookLikeCopies) {
  const std::vector<SampleJob> jobs = jobs_all_around(100000);
  const MeanEstimate copies =
      mean_of(trace(PathTracer(scene_of_spheres(false), workers()), Vec3(0.0F), jobs, 4));
  const MeanEstimate instances =
      mean_of(trace(PathTracer(scene_of_spheres(true), workers()), Vec3(0.0F), jobs, 4));
  EXPECT_GT(copies.mean(), 0.2);
  EXPECT_NEAR(instances.mean(), copies.mean(),
              5.0 * std::hypot(instances.standard_error(), copies.standard_error()));
}

/// Looks at one quad before a sky of radiance 1.
MeanEstimate seen_before_the_sky(const Material& material) {
  Scene scene;
  scene.materials = {material};
  scene.meshes = {quad(Vec3(-1, -1, -3), Vec3(2, 0, 0), Vec3(0, 2, 0), 0)};
  scene.environment = constant_environment(1.0F);
  return mean_radiance(scene, Vec3(0.0F), Vec3(0.1F, 0.2F, -1), 4, 40000);
}

TEST(PathTracerTest, BlendedSurfacesLetTheRestOfTheLightPass) {
  Material black = dielectric(0.0F);
  black.specular = 0.0F;
  black.alpha_mode = AlphaMode::blend;
  black.alpha = 0.3F;
  expect_mean(seen_before_the_sky(black), 0.7, 0.02);
}

TEST(PathTracerTest, UnlitSurfacesShowTheirColourWhateverShinesOnThem) {
  Material sign = dielectric(0.25F);
  sign.unlit = true;
  expect_mean(seen_before_the_sky(sign), 0.25, 1e-6);
}

TEST(PathTracerTest, AnUnlitSceneWithoutLightsIsNotDark) {
  Scene scene;
  scene.materials = {dielectric(0.25F)};
  scene.materials[0].unlit = true;
  scene.meshes = {quad(Vec3(-1, -1, -3), Vec3(2, 0, 0), Vec3(0, 2, 0), 0)};
  expect_mean(mean_radiance(scene, Vec3(0.0F), Vec3(0.1F, 0.2F, -1), 2, 100), 0.25, 1e-6);
}

TEST(PathTracerTest, ClampedSamplesAreCutChannelByChannel) {
  Scene scene;
  scene.environment = constant_environment(1.0F);
  scene.environment->radiance = Rgb(1.0F, 5.0F, 3.0F);
  scene.materials = {dielectric(0.5F)};
  const std::vector<SampleJob> jobs = jobs_along(Vec3(1, 0, 0), 1);
  std::vector<Rgb> radiance(1);
  PathTracer(scene, workers())
      .trace(Vec3(0.0F), jobs, radiance, {.largest_radiance = 3.5F}, workers());
  EXPECT_EQ(radiance[0], Rgb(1.0F, 3.5F, 3.0F));
}

}  // namespace
}  // namespace foveola
