// What scattering costs, by kind of material: made for a point, and then sampled or evaluated.
#include <array>
#include <vector>

#include <benchmark/benchmark.h>

#include "renderer/base/numbers/random.h"
#include "renderer/trace/materials/bsdf.h"
#include "renderer/trace/surfaces/surface.h"

namespace foveola {
namespace {

enum class Kind { diffuse, plastic, metal, rough_glass, clearcoat, sheen };

Material material_of(Kind kind) {
  Material material;
  material.base_color = Rgb(0.7F, 0.5F, 0.3F);
  material.roughness = 0.4F;
  material.specular = kind == Kind::diffuse ? 0.0F : 1.0F;
  material.metallic = kind == Kind::metal ? 1.0F : 0.0F;
  material.transmission = kind == Kind::rough_glass ? 1.0F : 0.0F;
  material.is_solid = kind == Kind::rough_glass;
  material.clearcoat = kind == Kind::clearcoat ? 1.0F : 0.0F;
  material.clearcoat_roughness = 0.1F;
  material.sheen_color = Rgb(kind == Kind::sheen ? 0.5F : 0.0F);
  material.sheen_roughness = 0.5F;
  return material;
}

/// The numbers, and directions above the surface, that the benchmarks go round.
struct Course {
  static constexpr std::size_t size = 1024;
  std::vector<Vec2> points;
  std::vector<Vec3> directions;

  Course() {
    for (std::uint64_t i = 0; i < size; ++i) {
      points.push_back(sobol_2d(i, 1));
      const Vec2 u = sobol_2d(i, 2);
      const float z = 0.05F + 0.95F * u.x;
      const float radius = std::sqrt(1.0F - z * z);
      const float azimuth = 6.2831853F * u.y;
      directions.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
    }
  }
};

/// Makes a BSDF, and has it used: use(bsdf, course, i) for a number i of the course.
template <typename Use>
void run(benchmark::State& state, Kind kind, const Use& use) {
  const Workers workers(1);
  const Material material = material_of(kind);
  const ScatteringTables tables(std::span(&material, 1), workers);
  const Reflectance reflectance = untextured_reflectance(material);
  const Course course;
  std::size_t i = 0;
  for (auto _ : state) {
    const Bsdf bsdf(reflectance, course.directions[i], tables);
    benchmark::DoNotOptimize(use(bsdf, course, i));
    i = (i + 1) % Course::size;
  }
  state.SetItemsProcessed(state.iterations());
}

void bsdf_sampled(benchmark::State& state, Kind kind) {
  run(state, kind, [](const Bsdf& bsdf, const Course& course, std::size_t i) {
    return bsdf.sample(course.points[Course::size - 1 - i].x, course.points[i]);
  });
}

void bsdf_evaluated(benchmark::State& state, Kind kind) {
  run(state, kind, [](const Bsdf& bsdf, const Course& course, std::size_t i) {
    return bsdf.eval(course.directions[Course::size - 1 - i]);
  });
}

BENCHMARK_CAPTURE(bsdf_sampled, diffuse, Kind::diffuse);
BENCHMARK_CAPTURE(bsdf_sampled, plastic, Kind::plastic);
BENCHMARK_CAPTURE(bsdf_sampled, metal, Kind::metal);
BENCHMARK_CAPTURE(bsdf_sampled, rough_glass, Kind::rough_glass);
BENCHMARK_CAPTURE(bsdf_sampled, clearcoat, Kind::clearcoat);
BENCHMARK_CAPTURE(bsdf_sampled, sheen, Kind::sheen);
BENCHMARK_CAPTURE(bsdf_evaluated, diffuse, Kind::diffuse);
BENCHMARK_CAPTURE(bsdf_evaluated, plastic, Kind::plastic);
BENCHMARK_CAPTURE(bsdf_evaluated, metal, Kind::metal);
BENCHMARK_CAPTURE(bsdf_evaluated, rough_glass, Kind::rough_glass);
BENCHMARK_CAPTURE(bsdf_evaluated, clearcoat, Kind::clearcoat);
BENCHMARK_CAPTURE(bsdf_evaluated, sheen, Kind::sheen);

}  // namespace
}  // namespace foveola
