#include "renderer/trace/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/random.h"
#include "renderer/trace/bsdf.h"
#include "renderer/trace/coat_albedo.h"
#include "renderer/trace/lights.h"
#include "renderer/trace/ray_scene.h"
#include "renderer/trace/surface.h"

namespace foveola {
namespace {

/// Paths that are traced together: at most so many that the state of all of them stays in the
/// second-level cache, at least enough shadow rays for Embree's streams, and between the two so few
/// that a preview's small batches keep every thread busy.
constexpr std::size_t largest_block = 512;
constexpr std::size_t smallest_block = 64;

std::size_t block_size(std::size_t jobs, int threads) {
  const std::size_t blocks_wanted = 2 * static_cast<std::size_t>(threads);
  return std::clamp(jobs / blocks_wanted, smallest_block, largest_block);
}

/// From the vertex after this one on, dim paths are ended at random.
constexpr int vertices_before_roulette = 3;

/// The density of a direction that no light sample could have given: the primary ray's.
constexpr float certain = std::numeric_limits<float>::infinity();

/// The power heuristic with exponent 2 (Veach 1997, section 9.2.4) for a sample of density `pdf`
/// that could also have come from a strategy of density `other`. As a ratio, which cannot overflow
/// into infinity over infinity.
float power_heuristic(float pdf, float other) {
  const float ratio = other / pdf;
  return 1.0F / (1.0F + ratio * ratio);
}

/// A path between two vertices.
struct Path {
  Vec3 origin;
  Vec3 direction;
  Rgb throughput{1.0F};
  Rgb radiance{0.0F};   ///< gathered so far
  float pdf = certain;  ///< per steradian, with which the BSDF gave the direction
  SampleStream random;
};

/// The random numbers of one vertex, always drawn all of them and in this order, so that a decision
/// has its own dimension whatever was decided before.
struct VertexNumbers {
  float light_kind, lobe, roulette;
  Vec2 light_choice, light_point, scattering;

  explicit VertexNumbers(SampleStream& random) {
    light_kind = random.next_1d();
    light_choice = random.next_2d();
    light_point = random.next_2d();
    lobe = random.next_1d();
    scattering = random.next_2d();
    roulette = random.next_1d();
  }
};

/// What a path gains if its shadow ray is not blocked.
struct PendingLight {
  std::size_t path;
  Rgb radiance;
};

}  // namespace

struct PathTracer::Implementation {
  const Scene& scene;
  RayScene rays;
  Lights lights;
  CoatAlbedo coat;

  Implementation(const Scene& source, const Workers& workers)
      : scene(source), rays(source, workers), lights(source), coat(workers) {}
};

namespace {

/// Traces one block of jobs, one vertex of all paths after the other.
class BlockTracer {
 public:
  BlockTracer(const Scene& scene, const RayScene& rays, const Lights& lights,
              const CoatAlbedo& coat, const TraceSettings& settings)
      : scene_(scene), rays_(rays), lights_(lights), coat_(coat), settings_(settings) {}

  RayCounts trace(const Vec3& viewpoint, std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
    start(viewpoint, jobs);
    for (vertex_ = 1; !active_.empty(); ++vertex_) {
      std::erase_if(active_, [this](std::size_t path) { return !advance(path); });
      add_unblocked_light();
    }
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      radiance[i] = paths_[i].radiance;
    }
    return counts_;
  }

 private:
  void start(const Vec3& viewpoint, std::span<const SampleJob> jobs) {
    paths_.reserve(jobs.size());
    active_.reserve(jobs.size());
    shadow_rays_.reserve(jobs.size());
    pending_.reserve(jobs.size());
    for (const SampleJob& job : jobs) {
      active_.push_back(paths_.size());
      paths_.push_back({.origin = viewpoint,
                        .direction = job.direction,
                        .random = SampleStream(settings_.seed, job.pixel, job.sample_number)});
    }
  }

  /// Takes a path to its next vertex and gathers light there. False if it ends there.
  bool advance(std::size_t index) {
    Path& path = paths_[index];
    const Hit hit = rays_.closest_hit(path.origin, path.direction);
    ++(vertex_ == 1 ? counts_.primary : counts_.bounce);
    if (hit.missed()) {
      add_environment(path);
      return false;
    }
    add_emission(path, hit);
    if (vertex_ > settings_.max_depth) {
      return false;
    }
    return scatter(index, hit);
  }

  void add_environment(Path& path) const {
    const Rgb radiance = lights_.environment_radiance(path.direction);
    if (max_component(radiance) > 0.0F) {
      const float weight = power_heuristic(path.pdf, lights_.environment_pdf(path.direction));
      path.radiance += path.throughput * radiance * weight;
    }
  }

  void add_emission(Path& path, const Hit& hit) const {
    const SurfaceEmission emission = surface_emission(scene_, hit, path.direction);
    if (max_component(emission.radiance) > 0.0F) {
      const float light_pdf = lights_.triangle_pdf(hit, hit.t, emission.cosine);
      path.radiance += path.throughput * emission.radiance * power_heuristic(path.pdf, light_pdf);
    }
  }

  /// Estimates the light that arrives at the vertex, and sends the path on. False if it ends.
  bool scatter(std::size_t index, const Hit& hit) {
    Path& path = paths_[index];
    const SurfacePoint point = surface_point(scene_, hit, path.direction);
    const Frame frame(point.shading_normal);
    const Bsdf bsdf(point.reflectance, frame.to_local(-path.direction), coat_);
    const VertexNumbers numbers(path.random);

    queue_light(index, point, frame, bsdf, numbers);

    const auto sample = bsdf.sample(numbers.lobe, numbers.scattering);
    if (!sample) {
      return false;
    }
    const Vec3 direction = glm::normalize(frame.to_world(sample->incoming));
    if (glm::dot(direction, point.geometric_normal) <= 0.0F) {
      return false;
    }
    path.origin = point.origin();
    path.direction = direction;
    path.throughput *= sample->weight;
    path.pdf = sample->pdf;
    return survives_roulette(path, numbers.roulette);
  }

  void queue_light(std::size_t index, const SurfacePoint& point, const Frame& frame,
                   const Bsdf& bsdf, const VertexNumbers& numbers) {
    const auto light = lights_.sample(point.origin(), numbers.light_kind, numbers.light_choice,
                                      numbers.light_point);
    if (!light || glm::dot(light->direction, point.geometric_normal) <= 0.0F) {
      return;
    }
    const BsdfValue value = bsdf.eval(frame.to_local(light->direction));
    const Rgb gain = paths_[index].throughput * value.times_cosine * light->radiance *
                     (power_heuristic(light->pdf, value.pdf) / light->pdf);
    if (max_component(gain) > 0.0F) {
      pending_.push_back({.path = index, .radiance = gain});
      shadow_rays_.push_back(light->shadow_ray);
    }
  }

  bool survives_roulette(Path& path, float u) const {
    const float brightest = max_component(path.throughput);
    if (vertex_ <= vertices_before_roulette || brightest >= 1.0F) {
      return brightest > 0.0F;
    }
    path.throughput /= brightest;
    return u < brightest;
  }

  void add_unblocked_light() {
    rays_.find_blocked(shadow_rays_);
    counts_.shadow += shadow_rays_.size();
    for (std::size_t i = 0; i < pending_.size(); ++i) {
      if (!shadow_rays_[i].is_blocked()) {
        paths_[pending_[i].path].radiance += pending_[i].radiance;
      }
    }
    pending_.clear();
    shadow_rays_.clear();
  }

  const Scene& scene_;
  const RayScene& rays_;
  const Lights& lights_;
  const CoatAlbedo& coat_;
  const TraceSettings& settings_;
  int vertex_ = 0;  ///< the one that the active paths are on their way to; the first is 1
  std::vector<Path> paths_;
  std::vector<std::size_t> active_;
  std::vector<Ray> shadow_rays_;
  std::vector<PendingLight> pending_;  ///< one a shadow ray
  RayCounts counts_;
};

}  // namespace

PathTracer::PathTracer(const Scene& scene, const Workers& workers)
    : implementation_(std::make_unique<Implementation>(scene, workers)) {}
PathTracer::~PathTracer() = default;
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;

RayCounts PathTracer::trace(const Vec3& viewpoint, std::span<const SampleJob> jobs,
                            std::span<Rgb> radiance, const TraceSettings& settings,
                            const Workers& workers) const {
  assert(jobs.size() == radiance.size());
  const Implementation& self = *implementation_;
  if (self.lights.empty()) {
    std::fill(radiance.begin(), radiance.end(), Rgb(0.0F));
    return {};
  }
  std::atomic<std::uint64_t> primary{0};
  std::atomic<std::uint64_t> bounce{0};
  std::atomic<std::uint64_t> shadow{0};
  const std::size_t block = block_size(jobs.size(), workers.threads());
  workers.for_each_block(jobs.size(), block, [&](std::size_t begin, std::size_t end) {
    BlockTracer tracer(self.scene, self.rays, self.lights, self.coat, settings);
    const RayCounts counts = tracer.trace(viewpoint, jobs.subspan(begin, end - begin),
                                          radiance.subspan(begin, end - begin));
    primary += counts.primary;
    bounce += counts.bounce;
    shadow += counts.shadow;
  });
  return {.primary = primary, .bounce = bounce, .shadow = shadow};
}

std::optional<Picked> PathTracer::pick(const Vec3& origin, const Vec3& direction) const {
  const float length = glm::length(direction);
  if (!(length > 0.0F)) {
    return std::nullopt;
  }
  const Vec3 unit = direction / length;
  const Hit hit = implementation_->rays.closest_hit(origin, unit);
  if (hit.missed()) {
    return std::nullopt;
  }
  return Picked{.object = hit.object, .position = origin + hit.t * unit, .distance = hit.t};
}

}  // namespace foveola
