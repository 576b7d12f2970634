#include "renderer/trace/block_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/base/angles.h"
#include "renderer/trace/bsdf.h"
#include "renderer/trace/mesh_attributes.h"
#include "renderer/trace/opacity.h"

namespace foveola {
namespace {

/// From the vertex after this one on, dim paths are ended at random.
constexpr int vertices_before_roulette = 3;

/// Windows in line that a ray may pass without a vertex, so that no scene traps a path.
constexpr int most_windows = 256;

/// The density of a direction that no light sample could have given: a camera's or a mirror's.
constexpr float certain = std::numeric_limits<float>::infinity();

/// The power heuristic with exponent 2 (Veach 1997, section 9.2.4) for a sample of density `pdf`
/// that could also have come from a strategy of density `other`. As a ratio, which cannot overflow
/// into infinity over infinity.
float power_heuristic(float pdf, float other) {
  if (pdf == certain) {
    return 1.0F;
  }
  const float ratio = other / pdf;
  return 1.0F / (1.0F + ratio * ratio);
}

/// How much a scattered ray widens: a tenth of the cone that holds as much solid angle as one
/// sample stands for. Textures seen by such rays are averaged over it.
float scattered_spread_rad(float pdf) {
  constexpr float widest_rad = 0.2F;
  return std::min(0.1F / std::sqrt(pdf), widest_rad);
}

Receiver receiver_at(const SurfacePoint& point) {
  return {.position = point.position,
          .normal = point.geometric_normal,
          .transmits = point.reflectance.transmission > 0.0F};
}

/// Moves the ray's start; where it ends stays.
void start_at(const Vec3& origin, Ray& ray) {
  if (std::isfinite(ray.t_max)) {
    ray.direction += ray.origin - origin;
  }
  ray.origin = origin;
}

}  // namespace

/// The random numbers of one vertex, always drawn all of them and in this order, so that a decision
/// has its own dimension whatever was decided before.
struct BlockTracer::VertexNumbers {
  float light_kind, lobe, roulette;
  Vec2 light_choice, light_point, scattering;
  std::uint32_t shadow_key, next_key;

  explicit VertexNumbers(SampleStream& random) {
    light_kind = random.next_1d();
    light_choice = random.next_2d();
    light_point = random.next_2d();
    lobe = random.next_1d();
    scattering = random.next_2d();
    roulette = random.next_1d();
    shadow_key = random.next_bits();
    next_key = random.next_bits();
  }

  /// Those of place i in a group.
  VertexNumbers(const GroupNumbers& group, std::size_t i);
};

/// The same for a group of paths.
struct BlockTracer::GroupNumbers {
  SampleStreams::Floats light_kind, lobe, roulette;
  SampleStreams::Pairs light_choice, light_point, scattering;
  SampleStreams::Bits shadow_key, next_key;

  explicit GroupNumbers(SampleStreams& random) {
    random.next_1d(light_kind);
    random.next_2d(light_choice);
    random.next_2d(light_point);
    random.next_1d(lobe);
    random.next_2d(scattering);
    random.next_1d(roulette);
    random.next_bits(shadow_key);
    random.next_bits(next_key);
  }
};

BlockTracer::VertexNumbers::VertexNumbers(const GroupNumbers& group, std::size_t i)
    : light_kind(group.light_kind[i]),
      lobe(group.lobe[i]),
      roulette(group.roulette[i]),
      light_choice(group.light_choice.x[i], group.light_choice.y[i]),
      light_point(group.light_point.x[i], group.light_point.y[i]),
      scattering(group.scattering.x[i], group.scattering.y[i]),
      shadow_key(group.shadow_key[i]),
      next_key(group.next_key[i]) {}

TracedScene::TracedScene(const Scene& source, const Workers& workers)
    : scene(source), rays(source, workers), lights(source), tables(source.materials, workers) {
  is_dark = lights.empty();
  for (const Material& material : source.materials) {
    traits.push_back({.is_unlit = material.unlit,
                      .is_window = is_window(material),
                      .absorption_per_m = absorption_per_m(material)});
    is_dark = is_dark && !material.unlit;
  }
}

RayCounts BlockTracer::trace(const Vec3& viewpoint, std::span<const SampleJob> jobs,
                             std::span<Rgb> radiance) {
  start(viewpoint, jobs);
  for (vertex_ = 1; !active_.empty(); ++vertex_) {
    advance_all();
    add_unblocked_light();
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    radiance[i] = glm::min(paths_[i].radiance, Rgb(settings_.largest_radiance));
  }
  return counts_;
}

void BlockTracer::start(const Vec3& viewpoint, std::span<const SampleJob> jobs) {
  paths_.reserve(jobs.size());
  active_.reserve(jobs.size());
  shadow_rays_.reserve(jobs.size());
  pending_.reserve(jobs.size());
  for (const SampleJob& job : jobs) {
    active_.push_back(paths_.size());
    paths_.push_back({.ray = {.origin = viewpoint, .direction = job.direction},
                      .pdf = certain,
                      .spread_rad = settings_.pixel_angle_rad,
                      .random = SampleStream(settings_.seed, job.pixel, job.sample_number)});
    paths_.back().ray.key = paths_.back().random.next_bits();
  }
}

void BlockTracer::advance_all() {
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < active_.size(); begin += SampleStreams::size) {
    const std::size_t count = std::min(SampleStreams::size, active_.size() - begin);
    SampleStreams random;
    for (std::size_t i = 0; i < count; ++i) {
      random.put(i, paths_[active_[begin + i]].random);
    }
    const GroupNumbers numbers(random);
    std::array<Hit, SampleStreams::size> hits;
    for (std::size_t i = 0; i < count; ++i) {
      Path& path = paths_[active_[begin + i]];
      random.take(i, path.random);
      hits[i] = closest_hit(path.ray);
      prefetch_triangle(traced_.scene, hits[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      prefetch_vertices(traced_.scene, hits[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t path = active_[begin + i];
      if (advance(path, hits[i], VertexNumbers(numbers, i))) {
        active_[kept++] = path;
      }
    }
  }
  active_.resize(kept);
}

Hit BlockTracer::closest_hit(const Ray& ray) {
  ++(vertex_ == 1 ? counts_.primary : counts_.bounce);
  if (notes_.rays != nullptr) {
    (vertex_ == 1 ? notes_.rays->primary : notes_.rays->bounce).push_back(ray);
  }
  return traced_.rays.closest_hit(ray);
}

bool BlockTracer::advance(std::size_t index, Hit hit, VertexNumbers numbers) {
  Path& path = paths_[index];
  for (int windows = 0; windows < most_windows; ++windows) {
    if (hit.missed()) {
      add_environment(path);
      note(path, hit);
      return false;
    }
    attenuate(path, hit);
    const Mesh& mesh = traced_.scene.mesh_of(hit.object);
    const MaterialTraits& traits = traced_.traits[static_cast<std::size_t>(mesh.material)];
    if (traits.is_unlit) {
      path.radiance += path.throughput * unlit_color(traced_.scene, hit);
      note(path, hit);
      return false;
    }
    add_emission(path, hit);
    note(path, hit);
    if (vertex_ > settings_.max_depth && !traits.is_window) {
      return false;
    }
    const Step step = scatter(index, hit, traits, numbers);
    if (step != Step::passed) {
      return step == Step::scattered;
    }
    numbers = VertexNumbers(path.random);
    path.ray.t_min = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
    hit = closest_hit(path.ray);
  }
  return false;
}

void BlockTracer::attenuate(Path& path, const Hit& hit) const {
  if (max_component(path.absorption_per_m) > 0.0F) {
    path.throughput *= glm::exp(-path.absorption_per_m * (hit.t - path.ray.t_min));
  }
}

void BlockTracer::add_environment(Path& path) const {
  const DistantLight light = traced_.lights.distant_light(path.ray.direction);
  if (max_component(light.radiance) > 0.0F) {
    path.radiance += path.throughput * light.radiance * power_heuristic(path.pdf, light.pdf);
  }
}

void BlockTracer::add_emission(Path& path, const Hit& hit) const {
  const SurfaceEmission emission = surface_emission(traced_.scene, hit, path.ray.direction);
  if (max_component(emission.radiance) > 0.0F) {
    const float light_pdf = traced_.lights.triangle_pdf(path.receiver, hit, hit.t, emission.cosine);
    path.radiance += path.throughput * emission.radiance * power_heuristic(path.pdf, light_pdf);
  }
}

BlockTracer::Step BlockTracer::scatter(std::size_t index, const Hit& hit,
                                       const MaterialTraits& traits, const VertexNumbers& numbers) {
  Path& path = paths_[index];
  const SurfacePoint point =
      surface_point(traced_.scene, hit, path.ray.direction, width_at(path, hit));
  const Frame frame(point.shading_normal);
  const Bsdf bsdf(point.reflectance, frame.to_local(-path.ray.direction), traced_.tables);
  const auto sample = bsdf.sample(numbers.lobe, numbers.scattering);
  const bool is_vertex = vertex_ <= settings_.max_depth;
  if (is_vertex) {
    queue_light(index, point, frame, bsdf, numbers);
  }
  if (!sample) {
    return Step::ended;
  }
  path.ray.key = numbers.next_key;
  if (traits.is_window && sample->is_specular && sample->incoming.z < 0.0F) {
    path.throughput *= sample->weight;
    return Step::passed;
  }
  path.width_m = width_at(path, hit);
  const bool continues = is_vertex && send(path, point, frame, *sample, traits) &&
                         survives_roulette(path, numbers.roulette);
  return continues ? Step::scattered : Step::ended;
}

bool BlockTracer::send(Path& path, const SurfacePoint& point, const Frame& frame,
                       const BsdfSample& sample, const MaterialTraits& traits) {
  const Vec3 direction = glm::normalize(frame.to_world(sample.incoming));
  const float side = glm::dot(direction, point.geometric_normal);
  if (side * sample.incoming.z <= 0.0F) {
    return false;
  }
  path.receiver = receiver_at(point);
  path.ray.origin = side > 0.0F ? point.origin : point.origin_beyond();
  path.ray.direction = direction;
  path.ray.t_min = 0.0F;
  path.throughput *= sample.weight;
  path.pdf = sample.is_specular ? certain : sample.pdf;
  path.radiance_scale *= sample.radiance_scale;
  if (!sample.is_specular && path.spread_rad > 0.0F) {
    path.spread_rad = std::max(path.spread_rad, scattered_spread_rad(sample.pdf));
  }
  if (side < 0.0F && point.reflectance.is_solid) {
    path.absorption_per_m = point.reflectance.from_inside ? Rgb(0.0F) : traits.absorption_per_m;
  }
  return true;
}

void BlockTracer::queue_light(std::size_t index, const SurfacePoint& point, const Frame& frame,
                              const Bsdf& bsdf, const VertexNumbers& numbers) {
  if (traced_.lights.empty()) {
    return;
  }
  const auto light = traced_.lights.sample(receiver_at(point), numbers.light_kind,
                                           numbers.light_choice, numbers.light_point);
  if (!light) {
    return;
  }
  const Vec3 incoming = frame.to_local(light->direction);
  const float side = glm::dot(light->direction, point.geometric_normal);
  if (side * incoming.z <= 0.0F) {
    return;
  }
  const BsdfValue value = bsdf.eval(incoming);
  const float weight = light->is_delta ? 1.0F : power_heuristic(light->pdf, value.pdf);
  const Rgb gain =
      paths_[index].throughput * value.times_cosine * light->radiance * (weight / light->pdf);
  if (max_component(gain) > 0.0F) {
    pending_.push_back({.path = index, .radiance = gain});
    shadow_rays_.push_back(light->shadow_ray);
    shadow_rays_.back().key = numbers.shadow_key;
    start_at(side < 0.0F ? point.origin_beyond() : point.origin, shadow_rays_.back());
  }
}

bool BlockTracer::survives_roulette(Path& path, float u) const {
  const float brightest = max_component(path.throughput) / path.radiance_scale;
  if (vertex_ <= vertices_before_roulette || brightest >= 1.0F) {
    return brightest > 0.0F;
  }
  path.throughput /= brightest;
  return u < brightest;
}

void BlockTracer::add_unblocked_light() {
  if (notes_.rays != nullptr) {
    auto& log = notes_.rays->shadow;
    log.insert(log.end(), shadow_rays_.begin(), shadow_rays_.end());
  }
  traced_.rays.find_blocked(shadow_rays_);
  counts_.shadow += shadow_rays_.size();
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (shadow_rays_[i].is_blocked()) {
      continue;
    }
    if (shadow_rays_[i].met_window()) {
      pending_[i].radiance *= window_transmittance(shadow_rays_[i]);
    }
    paths_[pending_[i].path].radiance += pending_[i].radiance;
  }
  pending_.clear();
  shadow_rays_.clear();
}

Rgb BlockTracer::window_transmittance(Ray ray) {
  Rgb transmittance(1.0F);
  const Vec3 direction = glm::normalize(ray.direction);
  for (int windows = 0; windows < most_windows; ++windows) {
    const Hit hit = traced_.rays.closest_hit(ray);
    ++counts_.window;
    if (notes_.rays != nullptr) {
      notes_.rays->window.push_back(ray);
    }
    if (hit.missed()) {
      return transmittance;
    }
    const Mesh& mesh = traced_.scene.mesh_of(hit.object);
    if (!traced_.traits[static_cast<std::size_t>(mesh.material)].is_window) {
      break;  // at an edge that the search for blockers only just missed
    }
    const SurfacePoint point = surface_point(traced_.scene, hit, direction);
    const Frame frame(point.shading_normal);
    transmittance *=
        Bsdf(point.reflectance, frame.to_local(-direction), traced_.tables).straight_transmission();
    ray.t_min = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
  }
  return Rgb(0.0F);
}

float BlockTracer::width_at(const Path& path, const Hit& hit) const {
  return path.width_m + path.spread_rad * hit.t;
}

void BlockTracer::note(const Path& path, const Hit& hit) const {
  if (notes_.vertices == nullptr) {
    return;
  }
  PathVertex vertex{.number = vertex_,
                    .direction = path.ray.direction,
                    .throughput = path.throughput,
                    .radiance = path.radiance,
                    .pdf = path.pdf};
  if (!hit.missed()) {
    vertex.object = hit.object;
    vertex.distance_m = hit.t;
    vertex.position = path.ray.origin + hit.t * path.ray.direction;
    vertex.normal = surface_point(traced_.scene, hit, path.ray.direction).shading_normal;
  }
  notes_.vertices->push_back(vertex);
}

}  // namespace foveola
