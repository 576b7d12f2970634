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
    std::size_t staying = 0;
    for (std::size_t first = 0; first < active_; first += lane_count) {
      const LanePacking packing(bits_of(advance(group_at(first))));
      paths_->move(first, packing, staying);
      staying += packing.count();
    }
    active_ = staying;
    add_unblocked_light();
  }
  for (Rgb& gathered : radiance) {
    gathered = glm::min(gathered, Rgb(settings_.largest_radiance));
  }
  return counts_;
}

void BlockTracer::start(const Vec3& viewpoint, std::span<const SampleJob> jobs) {
  paths_->fill({.ray = {.origin = viewpoint},
                .pdf = certain,
                .spread_rad = camera_spread_rad(settings_.pixel_angle_rad)});
  for (const SampleJob& job : jobs) {
    SampleStream random(settings_.seed, job.pixel, job.sample_number);
    paths_->direction.put(active_, job.direction);
    paths_->key[active_] = random.next_bits();
    paths_->random.put(active_, random);
    paths_->job[active_] = static_cast<std::uint32_t>(active_);
    ++active_;
  }
}

void BlockTracer::find_hits() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  ray_count() += active_;
  for (std::size_t first = 0; first < active_; first += lane_count) {
    const Group group = group_at(first);
    HitQueries queries({paths_->origin.load(first), paths_->direction.load(first),
                        all_lanes(infinity), paths_->key.load(first)});
    if (notes_.rays != nullptr) {
      for_each_lane(group.lanes(), [&](std::size_t lane) { note(queries.rays.at(lane)); });
    }
    traced_.rays.find_hits(queries, group.lanes());
    hits_->store(first, queries);
    for_each_lane(hits_->met_surface(first) & group.lanes(), [&](std::size_t lane) {
      const std::size_t index = first + lane;
      prefetch_triangle(*object_at(index).view.mesh, hits_->triangle[index]);
    });
  }
}

void BlockTracer::prefetch_group(std::size_t first) const {
  if (first >= active_) {
    return;
  }
  for_each_lane(hits_->met_surface(first) & group_at(first).lanes(), [&](std::size_t lane) {
    const std::size_t index = first + lane;
    prefetch_vertices(*object_at(index).view.mesh, hits_->triangle[index]);
  });
}

void BlockTracer::note(const Ray& ray) {
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
  SampleStreams random = paths_->random.load(group.first);
  const GroupNumbers numbers(random, needed_numbers());
  paths_->random.store(group.first, random);
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
  const Hit hit = hits_->at(index);
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

void BlockTracer::add_unblocked_light() {
  counts_.shadow += shadow_rays_.size();
  for (std::size_t first = 0; first < shadow_rays_.size(); first += lane_count) {
    add_unblocked_light(
        {.first = first, .size = std::min(lane_count, shadow_rays_.size() - first)});
  }
  shadow_rays_.clear();
}

void BlockTracer::add_unblocked_light(const Group& group) {
  RayLanes rays = shadow_rays_.rays(group.first);
  if (notes_.rays != nullptr) {
    for_each_lane(group.lanes(),
                  [&](std::size_t lane) { notes_.rays->shadow.push_back(rays.at(lane)); });
  }
  const LaneMask blocked = traced_.rays.find_blocked(rays, group.lanes());
  for_each_lane(group.lanes() & ~blocked, [&](std::size_t lane) {
    Rgb gain = shadow_rays_.gain(group.first + lane);
    if (rays.flags[lane] != 0) {
      gain *= thin_transmittance(rays.at(lane));
    }
    radiance_[shadow_rays_.job(group.first + lane)] += gain;
  });
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
