#include "renderer/trace/paths/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>

#include "renderer/base/numbers/random.h"
#include "renderer/base/turns.h"
#include "renderer/trace/paths/block_tracer.h"

namespace foveola {
namespace {

/// Paths per block: enough shadow rays for Embree's streams, and at the end so few that no thread
/// waits long for another.
constexpr BlockSizes block_sizes = {.smallest = 64, .largest = BlockTracer::max_paths};

/// Number of paths for learning.
constexpr std::size_t learning_paths = 1U << 14U;
constexpr std::uint32_t learning_seed = 0x1ea4;

std::vector<SampleJob> jobs_in_all_directions(std::size_t count) {
  std::vector<SampleJob> jobs(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 u = sobol_2d(i, learning_seed);
    const float height = 1.0F - 2.0F * u.y;
    const SineCosine azimuth = sine_cosine_of_turns(u.x - 0.5F);
    const float horizontal = std::sqrt(std::max(0.0F, 1.0F - height * height));
    jobs[i] = {.direction = {horizontal * azimuth.sine, height, horizontal * azimuth.cosine},
               .pixel = static_cast<std::uint32_t>(i)};
  }
  return jobs;
}

/// Outcomes of light samples on paths from the viewpoint in all directions.
std::vector<LightOutcome> light_outcomes(const TracedScene& traced, const Vec3& viewpoint,
                                         const Workers& workers) {
  const std::vector<SampleJob> jobs = jobs_in_all_directions(learning_paths);
  constexpr std::size_t block = BlockTracer::max_paths;
  std::vector<std::vector<LightOutcome>> outcomes((jobs.size() + block - 1) / block);
  workers.for_each_block(jobs.size(), block, [&](std::size_t begin, std::size_t end) {
    std::vector<Rgb> radiance(end - begin);
    BlockTracer tracer(traced, TraceSettings{.seed = learning_seed},
                       {.light_outcomes = &outcomes[begin / block]});
    tracer.trace(viewpoint, std::span(jobs).subspan(begin, end - begin), radiance);
  });
  std::vector<LightOutcome> all;
  for (const std::vector<LightOutcome>& some : outcomes) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}  // namespace

struct PathTracer::Implementation {
  Implementation(const Scene& scene, const Workers& workers, const LightSampling& lights,
                 KeptHierarchies* kept)
      : traced(scene, workers, lights, kept),
        learns(lights.learns && lights.selection == LightSelection::usual) {}

  TracedScene traced;
  bool learns;
};

PathTracer::PathTracer(const Scene& scene, const Workers& workers, const LightSampling& lights,
                       KeptHierarchies* kept)
    : implementation_(std::make_unique<Implementation>(scene, workers, lights, kept)) {}
PathTracer::~PathTracer() = default;
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;

RayCounts PathTracer::trace(const Vec3& viewpoint, std::span<const SampleJob> jobs,
                            std::span<Rgb> radiance, const TraceSettings& settings,
                            const Workers& workers) const {
  assert(jobs.size() == radiance.size());
  const TracedScene& traced = implementation_->traced;
  if (traced.is_dark) {
    std::ranges::fill(radiance, Rgb(0.0F));
    return {};
  }
  std::atomic<std::uint64_t> primary{0};
  std::atomic<std::uint64_t> bounce{0};
  std::atomic<std::uint64_t> shadow{0};
  std::atomic<std::uint64_t> transmittance{0};
  workers.for_each_shrinking_block(
      jobs.size(), block_sizes, [&](std::size_t begin, std::size_t end) {
        BlockTracer tracer(traced, settings);
        const RayCounts counts = tracer.trace(viewpoint, jobs.subspan(begin, end - begin),
                                              radiance.subspan(begin, end - begin));
        primary += counts.primary;
        bounce += counts.bounce;
        shadow += counts.shadow;
        transmittance += counts.transmittance;
      });
  return {.primary = primary, .bounce = bounce, .shadow = shadow, .transmittance = transmittance};
}

void PathTracer::learn_lights(const Vec3& viewpoint, const Workers& workers) {
  TracedScene& traced = implementation_->traced;
  if (implementation_->learns && traced.lights.can_learn()) {
    traced.lights.learn(light_outcomes(traced, viewpoint, workers));
  }
}

RayLog PathTracer::log_rays(const Vec3& viewpoint, std::span<const SampleJob> jobs,
                            const TraceSettings& settings) const {
  RayLog log;
  std::vector<Rgb> radiance(block_sizes.largest);
  const Workers alone(1);  // flushes denormals as trace() does
  alone.for_each_block(1, 1, [&](std::size_t, std::size_t) {
    for (std::size_t begin = 0; begin < jobs.size(); begin += block_sizes.largest) {
      const auto block = jobs.subspan(begin, std::min(block_sizes.largest, jobs.size() - begin));
      BlockTracer tracer(implementation_->traced, settings, {.rays = &log});
      tracer.trace(viewpoint, block, std::span(radiance).first(block.size()));
    }
  });
  return log;
}

std::vector<std::string> PathTracer::warnings() const {
  std::vector<std::string> lines;
  const TracedScene& traced = implementation_->traced;
  for (std::optional<std::string> line :
       {traced.lights.coincident().warning(), traced.warning_of_lights_without_size(),
        traced.warning_of_lights_met_by_chance()}) {
    if (line) {
      lines.push_back(std::move(*line));
    }
  }
  return lines;
}

const RayScene& PathTracer::ray_scene() const { return implementation_->traced.rays; }

PathRecord PathTracer::replay(const Vec3& viewpoint, const SampleJob& job,
                              const TraceSettings& settings) const {
  PathRecord record;
  BlockTracer tracer(implementation_->traced, settings, {.vertices = &record.vertices});
  const Workers alone(1);  // flushes denormals as trace() does
  alone.for_each_block(1, 1, [&](std::size_t, std::size_t) {
    tracer.trace(viewpoint, {&job, 1}, {&record.radiance, 1});
  });
  return record;
}

std::optional<Picked> PathTracer::pick(const Vec3& origin, const Vec3& direction) const {
  const float length = glm::length(direction);
  if (!(length > 0.0F)) {
    return std::nullopt;
  }
  const Vec3 unit = direction / length;
  const TracedScene& traced = implementation_->traced;
  const Hit hit = traced.rays.closest_hit(origin, unit);
  if (hit.missed()) {
    return std::nullopt;
  }
  return Picked{.object = hit.object,
                .material = traced.scene.mesh_of(hit.object).material,
                .position = origin + hit.t * unit,
                .distance_m = hit.t};
}

}  // namespace foveola
