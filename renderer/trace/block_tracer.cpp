#include "renderer/trace/block_tracer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/trace/bsdf.h"
#include "renderer/trace/mesh_attributes.h"
#include "renderer/trace/surface.h"
#include "renderer/trace/vertex_rules.h"

namespace foveola {

RayCounts BlockTracer::trace(const Vec3& viewpoint, std::span<const SampleJob> jobs,
                             std::span<Rgb> radiance) {
  assert(jobs.size() <= most_paths);
  radiance_ = radiance;
  std::fill(radiance.begin(), radiance.end(), Rgb(0.0F));
  start(viewpoint, jobs);
  for (vertex_ = 1; active_ > 0; ++vertex_) {
    find_hits();
    prefetch_group(0);
    for (std::size_t first = 0; first < active_; first += lane_count) {
      const Group group{.first = first, .size = std::min(lane_count, active_ - first)};
      const LaneMask lanes = advance(group);
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        goes_on_[first + lane] = lanes[lane] != 0;
      }
    }
    close_gaps();
    add_unblocked_light();
  }
  for (Rgb& gathered : radiance) {
    gathered = glm::min(gathered, Rgb(settings_.largest_radiance));
  }
  return counts_;
}

void BlockTracer::start(const Vec3& viewpoint, std::span<const SampleJob> jobs) {
  shadow_rays_.reserve(jobs.size());
  pending_.reserve(jobs.size());
  paths_->fill({.ray = {.origin = viewpoint},
                .pdf = certain,
                .spread_rad = camera_spread_rad(settings_.pixel_angle_rad)});
  for (const SampleJob& job : jobs) {
    SampleStream random(settings_.seed, job.pixel, job.sample_number);
    paths_->direction.put(active_, job.direction);
    paths_->key[active_] = random.next_bits();
    paths_->random[active_] = random;
    paths_->job[active_] = static_cast<std::uint32_t>(active_);
    ++active_;
  }
}

void BlockTracer::find_hits() {
  const std::span<HitQuery> queries = std::span(queries_).first(active_);
  for (std::size_t i = 0; i < active_; ++i) {
    queries[i].ask(paths_->ray(i));
    count(queries[i].ray);
  }
  traced_.rays.find_hits(queries);
  for (std::size_t i = 0; i < active_; ++i) {
    hits_[i] = queries[i].hit();
    prefetch_triangle(traced_.scene, hits_[i]);
  }
}

void BlockTracer::prefetch_group(std::size_t first) const {
  for (std::size_t i = first; i < std::min(first + lane_count, active_); ++i) {
    prefetch_vertices(traced_.scene, hits_[i]);
  }
}

void BlockTracer::count(const Ray& ray) {
  ++(vertex_ == 1 ? counts_.primary : counts_.bounce);
  if (notes_.rays != nullptr) {
    (vertex_ == 1 ? notes_.rays->primary : notes_.rays->bounce).push_back(ray);
  }
}

LaneMask BlockTracer::advance(const Group& group) {
  prefetch_group(group.first + lane_count);
  LaneMask on_fast_path{};
  LaneMask on_general_path{};
  for (std::size_t lane = 0; lane < group.size; ++lane) {
    const Arrival arrival = arrive(group.first + lane);
    on_fast_path[lane] = arrival == Arrival::fast_path ? -1 : 0;
    on_general_path[lane] = arrival == Arrival::general_path ? -1 : 0;
  }
  if (!any_lane(on_fast_path | on_general_path)) {
    return LaneMask{};
  }
  const GroupNumbers numbers(std::span(paths_->random).subspan(group.first, group.size),
                             needed_numbers());
  LaneMask goes_on{};
  if (any_lane(on_general_path)) {
    goes_on = advance_alone(group, on_general_path, numbers);
  }
  if (any_lane(on_fast_path)) {
    goes_on |= advance_on_fast_path(group, on_fast_path, numbers);
  }
  return goes_on;
}

NeededNumbers BlockTracer::needed_numbers() const {
  const bool all = takes_general_path_;
  return {.light_kind = all || traced_.lights.has_several_kinds(),
          .roulette = all || vertex_ > settings_.vertices_before_roulette,
          .keys = all || traced_.rays.asks_for_keys()};
}

BlockTracer::Arrival BlockTracer::arrive(std::size_t index) {
  const Hit& hit = hits_[index];
  const bool is_absorbed =
      traced_.has_absorption && paths_->absorption_per_m.at(index) != Rgb(0.0F);
  if (hit.missed() || is_absorbed || notes_.vertices != nullptr || object_of(hit).shines) {
    Path path = paths_->at(index);
    if (!gather(path, hit)) {
      return Arrival::ended;
    }
    paths_->throughput.put(index, path.throughput);
  } else if (is_last(object_of(hit))) {
    return Arrival::ended;
  }
  const bool is_on_fast_path =
      object_of(hit).is_on_fast_path && !is_absorbed && !takes_general_path_;
  return is_on_fast_path ? Arrival::fast_path : Arrival::general_path;
}

bool BlockTracer::is_last(const TracedObject& object) const {
  return vertex_ > settings_.max_depth && !object.is_thin_transmissive;
}

bool BlockTracer::gather(Path& path, const Hit& hit) {
  path.throughput *= transmittance(path.absorption_per_m, hit.t - path.ray.t_min);
  if (hit.missed()) {
    add_environment(path);
    note(path, hit);
    return false;
  }
  const TracedObject& object = object_of(hit);
  if (object.is_unlit) {
    radiance_[path.job] += path.throughput * unlit_color(traced_.scene, hit);
    note(path, hit);
    return false;
  }
  add_emission(path, hit);
  note(path, hit);
  return !is_last(object);
}

void BlockTracer::add_environment(const Path& path) {
  const DistantLight light = traced_.lights.distant_light(path.shading_point, path.ray.direction);
  if (max_component(light.radiance) > 0.0F) {
    radiance_[path.job] += path.throughput * light.radiance *
                           power_heuristic(path.pdf, light_samples_weighed_ * light.pdf);
  }
}

void BlockTracer::add_emission(const Path& path, const Hit& hit) {
  const SurfaceEmission emission = surface_emission(traced_.scene, hit, path.ray.direction);
  if (max_component(emission.radiance) > 0.0F) {
    const float light_pdf =
        traced_.lights.triangle_pdf(path.shading_point, hit, hit.t, emission.cosine);
    radiance_[path.job] += path.throughput * emission.radiance *
                           power_heuristic(path.pdf, light_samples_weighed_ * light_pdf);
  }
}

bool BlockTracer::finite(std::uint32_t job, const Rgb& radiance, const Vec3& direction) {
  if (is_finite(radiance) && is_finite(direction)) {
    return true;
  }
  radiance_[job] = not_a_number;
  return false;
}

void BlockTracer::close_gaps() {
  for (std::size_t i = 0;; ++i) {
    while (i < active_ && goes_on_[i]) {
      ++i;
    }
    while (i < active_ && !goes_on_[active_ - 1]) {
      --active_;
    }
    if (i == active_) {
      return;
    }
    paths_->put(i, paths_->at(--active_));
  }
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
    if (shadow_rays_[i].met_thin_surface()) {
      pending_[i].radiance *= thin_transmittance(shadow_rays_[i]);
    }
    radiance_[pending_[i].job] += pending_[i].radiance;
  }
  pending_.clear();
  shadow_rays_.clear();
}

Rgb BlockTracer::thin_transmittance(Ray ray) {
  Rgb transmittance(1.0F);
  const Vec3 direction = glm::normalize(ray.direction);
  for (int thin_surfaces = 0; thin_surfaces < most_thin_surfaces; ++thin_surfaces) {
    const Hit hit = traced_.rays.closest_hit(ray);
    ++counts_.transmittance;
    if (notes_.rays != nullptr) {
      notes_.rays->transmittance.push_back(ray);
    }
    if (hit.missed()) {
      return transmittance;
    }
    if (!object_of(hit).is_thin_transmissive) {
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

void BlockTracer::note(const Path& path, const Hit& hit) const {
  if (notes_.vertices == nullptr) {
    return;
  }
  PathVertex vertex{.number = vertex_,
                    .direction = path.ray.direction,
                    .throughput = path.throughput,
                    .radiance = radiance_[path.job],
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
