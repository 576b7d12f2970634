#include "renderer/trace/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cassert>

#include "renderer/trace/block_tracer.h"

namespace foveola {
namespace {

/// Paths that are traced together: enough shadow rays for Embree's streams, and at the end so few
/// that no thread waits long for another.
constexpr BlockSizes block_sizes = {.smallest = 64, .largest = BlockTracer::most_paths};

}  // namespace

struct PathTracer::Implementation {
  Implementation(const Scene& scene, const Workers& workers, const LightSampling& lights,
                 KeptHierarchies* kept)
      : traced(scene, workers, lights, kept) {}

  TracedScene traced;
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
    std::fill(radiance.begin(), radiance.end(), Rgb(0.0F));
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
