// What a ray costs: closest hits and shadow rays among triangles that fill a cube.
#include <vector>

#include <benchmark/benchmark.h>

#include "renderer/base/numbers/random.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {
namespace {

constexpr std::size_t ray_count = 4096;

Vec3 in_cube(Pcg32& generator) {
  const auto coordinate = [&] { return static_cast<float>(2.0 * generator.uniform() - 1.0); };
  const float x = coordinate();
  const float y = coordinate();
  return {x, y, coordinate()};
}

/// Triangles of about a fiftieth of the cube's side.
Scene confetti(std::size_t triangles) {
  constexpr float size = 0.04F;
  Pcg32 generator(1);
  Mesh mesh;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const Vec3 corner = in_cube(generator);
    mesh.positions.push_back(corner);
    mesh.positions.push_back(corner + size * in_cube(generator));
    mesh.positions.push_back(corner + size * in_cube(generator));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  Scene scene;
  scene.materials.emplace_back();
  scene.meshes.push_back(std::move(mesh));
  return scene;
}

/// From anywhere to anywhere, as after a diffuse bounce.
std::vector<Ray> scattered_rays() {
  Pcg32 generator(2);
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < ray_count; ++i) {
    const Vec3 origin = in_cube(generator);
    rays.push_back({.origin = origin, .direction = glm::normalize(in_cube(generator))});
  }
  return rays;
}

/// From the middle, neighbours beside each other.
std::vector<Ray> fanned_rays() {
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < ray_count; ++i) {
    const float x = static_cast<float>(i % 64) / 64.0F - 0.5F;
    const float y = static_cast<float>(i / 64) / 64.0F - 0.5F;
    rays.push_back({.origin = Vec3(0.0F), .direction = glm::normalize(Vec3(x, y, -1.0F))});
  }
  return rays;
}

void closest_hits(benchmark::State& state, std::vector<Ray> (*make_rays)()) {
  const Workers workers(1);
  const Scene scene = confetti(static_cast<std::size_t>(state.range(0)));
  const RayScene ray_scene(scene, workers);
  const std::vector<Ray> rays = make_rays();
  workers.for_each_block(1, 1, [&](std::size_t, std::size_t) {  // flushes denormals, as Embree asks
    for (auto _ : state) {
      for (const Ray& ray : rays) {
        benchmark::DoNotOptimize(ray_scene.closest_hit(ray));
      }
    }
  });
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(ray_count));
}
BENCHMARK_CAPTURE(closest_hits, fanned, fanned_rays)->Arg(10'000)->Arg(1'000'000);
BENCHMARK_CAPTURE(closest_hits, scattered, scattered_rays)->Arg(10'000)->Arg(1'000'000);

void shadow_rays(benchmark::State& state) {
  const Workers workers(1);
  const Scene scene = confetti(static_cast<std::size_t>(state.range(0)));
  const RayScene ray_scene(scene, workers);
  const std::vector<Ray> rays = scattered_rays();
  RayStream stream(rays.size());
  workers.for_each_block(1, 1, [&](std::size_t, std::size_t) {
    for (auto _ : state) {
      stream.clear();
      for (const Ray& ray : rays) {
        stream.add(ray.origin, ray.direction, 0.5F, ray.key);
      }
      ray_scene.find_blocked(stream);
      benchmark::DoNotOptimize(stream.is_blocked(0));
    }
  });
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(ray_count));
}
BENCHMARK(shadow_rays)->Arg(10'000)->Arg(1'000'000);

}  // namespace
}  // namespace foveola
