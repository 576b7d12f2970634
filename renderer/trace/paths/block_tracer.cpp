#include "renderer/trace/paths/block_tracer.h"

#include <cassert>
#include <cmath>

#include "renderer/trace/rays/mesh_attributes.h"

namespace foveola {

RayCounts BlockTracer::trace(const Vec3& viewpoint, std::span<const SampleJob> jobs,
                             std::span<Rgb> radiance) {
  assert(jobs.size() <= max_paths);
  radiance_ = radiance;
  std::ranges::fill(radiance, Rgb(0.0F));
  start(viewpoint, jobs);
  for (vertex_ = 1; active_ > 0; ++vertex_) {
    find_hits();
    prefetch_group(0);
    std::size_t staying = 0;
    for (std::size_t first = 0; first < active_; first += lane_count) {
      const LanePacking packing(bits_of(advance(group_at(first))));
      if (packing.count() < lane_count || staying < first) {
        paths_->move(first, packing, staying);
      }
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
                .absorption_per_m = traced_.absorption_at(viewpoint),
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
  ray_count() += active_;
  for (std::size_t first = 0; first < active_; first += lane_count) {
    const Group group = group_at(first);
    HitQueries queries(
        {paths_->origin.load(first), paths_->direction.load(first), paths_->key.load(first)});
    if (notes_.rays != nullptr) {
      for_each_lane(group.lanes(), [&](std::size_t lane) { note(queries.rays.at(lane)); });
    }
    traced_.rays.find_hits(queries, group.lanes());
    hits_->store(first, queries);
    if (!traced_.lights.coincident().empty()) {
      for_each_lane(hits_->met_surface(first) & group.lanes(), [&](std::size_t lane) {
        const std::size_t index = first + lane;
        hits_->put(index,
                   traced_.lights.coincident().seen(hits_->at(index), paths_->direction.at(index)));
      });
    }
  }
  for (std::size_t first = 0; first < active_; first += lane_count) {
    for_each_lane(hits_->met_surface(first) & group_at(first).lanes(), [&](std::size_t lane) {
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
  const Surfaces surfaces = surfaces_of(group);
  const LaneMask absorbed = in_absorption(group);
  const LaneMask arrived = arrive(group, surfaces, absorbed);
  if (!any_lane(arrived)) {
    return arrived;
  }
  SampleStreams random = paths_->random.load(group.first);
  const GroupNumbers numbers(random, needed_numbers());
  paths_->random.store(group.first, random);
  const LaneMask on_fast_path =
      takes_general_path_ ? LaneMask{} : arrived & surfaces.on_fast_path & ~absorbed;
  const LaneMask on_general_path = arrived & ~on_fast_path;
  LaneMask goes_on{};
  if (any_lane(on_general_path)) {
    goes_on = advance_alone(group, on_general_path, numbers);
  }
  if (any_lane(on_fast_path)) {
    goes_on |= advance_on_fast_path(group, on_fast_path, surfaces.normal_mapped, numbers);
  }
  return goes_on;
}

NeededNumbers BlockTracer::needed_numbers() const {
  const bool all = takes_general_path_;
  return {.light_kind = all || traced_.lights.has_several_kinds(),
          .light_choice = all || traced_.lights.has_several_of_a_kind(),
          .lobe = all || traced_.has_other_lobes,
          .roulette = all || vertex_ > settings_.vertices_before_roulette,
          .keys = all || traced_.rays.asks_for_keys() || traced_.follows_suns_through_glass};
}

BlockTracer::Surfaces BlockTracer::surfaces_of(const Group& group) const {
  UintLanes traits{};
  for_each_lane(hits_->met_surface(group.first) & group.lanes(), [&](std::size_t lane) {
    traits[lane] = traced_.traits[hits_->object[group.first + lane]];
  });
  const Uints all = traits.load();
  const auto with = [&](std::uint32_t trait) { return LaneMask((all & trait) != 0U); };
  return {.shining = with(ObjectTraits::shines),
          .thin_transmissive = with(ObjectTraits::is_thin_transmissive),
          .on_fast_path = with(ObjectTraits::is_on_fast_path),
          .normal_mapped = with(ObjectTraits::has_normal_map)};
}

LaneMask BlockTracer::in_absorption(const Group& group) const {
  if (!traced_.has_absorption) {
    return LaneMask{};
  }
  const Vec3s absorption = paths_->absorption_per_m.load(group.first);
  return group.lanes() & ((absorption.x != 0.0F) | (absorption.y != 0.0F) | (absorption.z != 0.0F));
}

LaneMask BlockTracer::arrive(const Group& group, const Surfaces& surfaces,
                             const LaneMask& absorbed) {
  const LaneMask met_surface = hits_->met_surface(group.first);
  LaneMask arrived = group.lanes() & met_surface & ~surfaces.shining & ~absorbed;
  if (notes_.vertices != nullptr) {
    arrived = LaneMask{};
  } else if (traced_.lights.has_spheres()) {
    arrived &= ~traced_.lights.may_hit_sphere(paths_->origin.load(group.first),
                                              paths_->direction.load(group.first));
  }
  const LaneMask gathering = group.lanes() & ~arrived;
  if (vertex_ > settings_.max_depth) {
    arrived &= surfaces.thin_transmissive;
  }
  for_each_lane(gathering, [&](std::size_t lane) {
    const std::size_t index = group.first + lane;
    Path path = paths_->at(index);
    if (gather(path, hits_->at(index))) {
      paths_->throughput.put(index, path.throughput);
      arrived[lane] = -1;
    }
  });
  return arrived;
}

bool BlockTracer::is_last(const TracedObject& object) const {
  return vertex_ > settings_.max_depth && !object.is_thin_transmissive;
}

bool BlockTracer::gather(Path& path, const Hit& hit) {
  if (traced_.lights.has_spheres()) {
    add_spheres(path, hit);
  }
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
    const float weight = path.pdf == certain
                             ? path.distant_weight
                             : power_heuristic(path.pdf, light_samples_weighed_ * light.pdf);
    radiance_[path.job] += path.throughput * light.radiance * weight;
  }
}

void BlockTracer::add_spheres(const Path& path, const Hit& hit) {
  const auto add = [&](const PunctualLights::SphereHit& sphere) {
    if (sphere.t > path.ray.t_min && sphere.t < hit.t) {
      radiance_[path.job] += path.throughput * sphere.radiance *
                             transmittance(path.absorption_per_m, sphere.t - path.ray.t_min) *
                             power_heuristic(path.pdf, light_samples_weighed_ * sphere.pdf);
    }
  };
  traced_.lights.visit_spheres(path.shading_point, path.ray, add);
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

Hit BlockTracer::closest_hit(const Ray& ray) const {
  const Hit hit = traced_.rays.closest_hit(ray);
  return hit.missed() ? hit : traced_.lights.coincident().seen(hit, ray.direction);
}

bool BlockTracer::finite(std::uint32_t job, const Rgb& radiance, const Vec3& direction) {
  if (is_finite(radiance) && is_finite(direction)) {
    return true;
  }
  radiance_[job] = not_a_number;
  return false;
}

void BlockTracer::add_unblocked_light() {
  if (notes_.rays != nullptr) {
    for (std::size_t i = 0; i < shadow_rays_.size(); ++i) {
      notes_.rays->shadow.push_back(shadow_ray(i));
    }
  }
  traced_.rays.find_blocked(shadow_rays_);
  counts_.shadow += shadow_rays_.size();
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (shadow_rays_.is_blocked(i)) {
      const bool may_pass_glass = traced_.follows_suns_through_glass && pending_[i].is_distant &&
                                  traced_.lights.is_in_sun(shadow_rays_.direction(i));
      const Rgb passing =
          may_pass_glass ? glass_transmittance(shadow_ray(i), pending_[i].job) : Rgb(0.0F);
      if (passing == Rgb(0.0F)) {
        if (notes_.light_outcomes != nullptr) {
          (*notes_.light_outcomes)[pending_outcomes_[i]].gain = 0.0F;
        }
        continue;
      }
      pending_[i].radiance *= passing;
    } else if (shadow_rays_.met_thin_surface(i)) {
      pending_[i].radiance *= thin_transmittance(shadow_ray(i));
    }
    radiance_[pending_[i].job] += pending_[i].radiance;
  }
  pending_.clear();
  pending_outcomes_.clear();
  shadow_rays_.clear();
}

Ray BlockTracer::shadow_ray(std::size_t i) const {
  return {.origin = shadow_rays_.origin(i),
          .direction = shadow_rays_.direction(i),
          .t_max = shadow_rays_.t_max(i),
          .key = shadow_rays_.key(i)};
}

Rgb BlockTracer::glass_transmittance(const Ray& shadow_ray, std::uint32_t job) {
  Path path{.ray = shadow_ray,
            .pdf = certain,
            .random = SampleStream(settings_.seed, shadow_ray.key, 0),
            .job = job};
  path.ray.t_max = std::numeric_limits<float>::infinity();
  const auto arriving = [&] {
    return traced_.lights.distant_light(path.shading_point, path.ray.direction).radiance;
  };
  const Rgb unhindered = arriving();
  int vertex = vertex_;
  for (int surfaces = 0; surfaces < max_thin_surfaces; ++surfaces) {
    const Hit hit = closest_hit(path.ray);
    ++counts_.transmittance;
    if (notes_.rays != nullptr) {
      notes_.rays->transmittance.push_back(path.ray);
    }
    path.throughput *= transmittance(path.absorption_per_m, hit.t - path.ray.t_min);
    if (hit.missed()) {
      const Rgb ratio = path.throughput * arriving() / unhindered;
      return {unhindered.r > 0.0F ? ratio.r : 0.0F, unhindered.g > 0.0F ? ratio.g : 0.0F,
              unhindered.b > 0.0F ? ratio.b : 0.0F};
    }
    const TracedObject& object = object_of(hit);
    const bool is_thin = object.is_thin_transmissive;
    if (object.is_unlit || (!is_thin && (!object.refracts || ++vertex > settings_.max_depth))) {
      break;
    }
    const VertexNumbers numbers(path.random);
    const SurfacePoint point = surface_point(traced_.scene, hit, path.ray.direction);
    const Frame frame(point.shading_normal);
    const auto sample = bsdf_at(point, frame, path.ray.direction, traced_.tables)
                            .sample(numbers.lobe, numbers.scattering);
    if (!sample || !sample->is_specular || (is_thin && !sample->is_transmitted)) {
      break;
    }
    path.ray.key = numbers.next_key;
    if (is_thin) {
      path.throughput *= sample->weight;
      path.ray.t_min = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
    } else if (!send(path, hit, point, {}, frame, *sample, object)) {
      break;
    }
  }
  return Rgb(0.0F);
}

Rgb BlockTracer::thin_transmittance(Ray ray) {
  Rgb transmittance(1.0F);
  const Vec3 direction = glm::normalize(ray.direction);
  for (int thin_surfaces = 0; thin_surfaces < max_thin_surfaces; ++thin_surfaces) {
    const Hit hit = traced_.rays.closest_hit(ray);
    ++counts_.transmittance;
    if (notes_.rays != nullptr) {
      notes_.rays->transmittance.push_back(ray);
    }
    if (hit.missed()) {
      return transmittance;
    }
    if (!object_of(hit).is_thin_transmissive) {
      break;  // an edge that the search for blockers just missed
    }
    const SurfacePoint point = surface_point(traced_.scene, hit, direction);
    const Frame frame(point.shading_normal);
    transmittance *= bsdf_at(point, frame, direction, traced_.tables).straight_transmission();
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
