// The part of BlockTracer that works on vertices of any kind, one after the other.
#include <algorithm>
#include <cmath>

#include "renderer/trace/paths/block_tracer.h"
#include "renderer/trace/paths/vertex_rules.h"

namespace foveola {
namespace {

/// For a transmitting surface the triangle's orientation decides the side of the light.
ShadingPoint shading_point_at(const SurfacePoint& point, const Lights& lights) {
  const bool transmits = point.reflectance.transmission > 0.0F;
  const Vec3& normal = transmits ? point.geometric_normal : point.horizon_normal;
  return {.position = point.position,
          .normal = normal,
          .transmits = transmits,
          .region = lights.region_of(point.position, normal)};
}

/// The absorption on the other side of the surface at a path's vertex.
Rgb absorption_beyond(const Path& path, const Reflectance& surface, const Rgb& inside) {
  if (!surface.is_solid) {
    return path.absorption_per_m;
  }
  return surface.from_inside ? Rgb(0.0F) : inside;
}

float width_at(const Path& path, const Hit& hit) { return path.width_m + path.spread_rad * hit.t; }

}  // namespace

LaneMask BlockTracer::advance_alone(const Group& group, const LaneMask& lanes,
                                    const GroupNumbers& numbers) {
  LaneMask goes_on{};
  for_each_lane(lanes, [&](std::size_t lane) {
    goes_on[lane] = advance_alone(group.first + lane, VertexNumbers(numbers, lane)) ? -1 : 0;
  });
  return goes_on;
}

bool BlockTracer::advance_alone(std::size_t index, VertexNumbers numbers) {
  Path path = paths_->at(index);
  Hit hit = hits_->at(index);
  for (int thin_surfaces = 0; thin_surfaces < max_thin_surfaces; ++thin_surfaces) {
    const Step step = scatter(path, hit, object_of(hit), numbers);
    if (step != Step::passed) {
      paths_->put(index, path);
      return step == Step::scattered;
    }
    numbers = VertexNumbers(path.random);
    path.ray.t_min = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
    ++ray_count();
    note(path.ray);
    hit = closest_hit(path.ray);
    if (!gather(path, hit)) {
      return false;
    }
  }
  return false;
}

BlockTracer::Step BlockTracer::scatter(Path& path, const Hit& hit, const TracedObject& object,
                                       const VertexNumbers& numbers) {
  const SurfacePoint point =
      surface_point(traced_.scene, hit, path.ray.direction, width_at(path, hit));
  const Frame frame(point.shading_normal);
  const Bsdf bsdf = bsdf_at(point, frame, path.ray.direction, traced_.tables);
  const auto sample = bsdf.sample(numbers.lobe, numbers.scattering);
  const bool is_vertex = vertex_ <= settings_.max_depth;
  const ShadingPoint shading_point = shading_point_at(point, traced_.lights);
  if (is_vertex) {
    queue_light(path, hit, point, shading_point, frame, bsdf, object, numbers);
  }
  if (!sample) {
    return Step::ended;
  }
  path.ray.key = numbers.next_key;
  if (object.is_thin_transmissive && sample->is_specular && sample->is_transmitted) {
    path.throughput *= sample->weight;
    return Step::passed;
  }
  path.width_m = width_at(path, hit);
  const bool continues = is_vertex &&
                         send(path, hit, point, shading_point, frame, *sample, object) &&
                         survives_roulette(path, numbers.roulette);
  return continues ? Step::scattered : Step::ended;
}

bool BlockTracer::lift_origin(const Hit& hit, const Vec3& geometric_normal, Vec3& origin) {
  const Vec3 bulge = smooth_bulge(traced_.scene, hit, geometric_normal);
  if (!(glm::dot(bulge, geometric_normal) > 0.0F)) {
    return false;
  }
  Ray ray{.origin = origin, .direction = bulge};
  ray.t_max = 1.0F;
  ++counts_.shadow;
  if (notes_.rays != nullptr) {
    notes_.rays->shadow.push_back(ray);
  }
  if (!traced_.rays.closest_hit(ray).missed()) {
    return false;
  }
  origin += bulge;
  return true;
}

bool BlockTracer::send(Path& path, const Hit& hit, const SurfacePoint& point,
                       const ShadingPoint& shading_point, const Frame& frame,
                       const BsdfSample& sample, const TracedObject& object) {
  Vec3 direction = glm::normalize(frame.to_world(sample.incoming));
  const Vec3& horizon = sample.is_specular ? point.geometric_normal : shading_point.normal;
  float side = glm::dot(direction, horizon);
  if ((sample.is_transmitted ? -side : side) <= 0.0F) {
    if (!sample.is_specular || side == 0.0F) {
      return false;
    }
    // At the rims of smooth-shaded objects, where mirrors would lose light.
    direction -= 2.0F * side * point.geometric_normal;
    side = -side;
  }
  path.ray.origin = side > 0.0F ? point.origin : point.origin_beyond();
  if (side > 0.0F && glm::dot(direction, point.geometric_normal) <= 0.0F &&
      !lift_origin(hit, point.geometric_normal, path.ray.origin)) {
    return false;
  }
  if (sample.is_specular && traced_.follows_suns_through_glass) {
    path.distant_weight = distant_weight_beyond(path, object);
  }
  path.shading_point = shading_point;
  path.ray.direction = direction;
  path.ray.t_min = 0.0F;
  path.throughput *= sample.weight;
  path.pdf = sample.is_specular ? certain : sample.pdf;
  path.radiance_scale *= sample.radiance_scale;
  if (!sample.is_specular && path.spread_rad > 0.0F) {
    path.spread_rad = std::max(path.spread_rad, scattered_spread_rad(sample.pdf));
  }
  if (side < 0.0F) {
    path.absorption_per_m = absorption_beyond(path, point.reflectance, object.absorption_per_m);
  }
  return finite(path.job, path.throughput, direction);
}

void BlockTracer::queue_light(const Path& path, const Hit& hit, const SurfacePoint& point,
                              const ShadingPoint& shading_point, const Frame& frame,
                              const Bsdf& bsdf, const TracedObject& object,
                              const VertexNumbers& numbers) {
  if (traced_.lights.empty()) {
    return;
  }
  const auto light = traced_.lights.sample(shading_point, numbers.light_kind, numbers.light_choice,
                                           numbers.light_point);
  if (notes_.light_outcomes != nullptr) {
    notes_.light_outcomes->push_back(traced_.lights.outcome(
        shading_point, numbers.light_kind, numbers.light_choice, numbers.light_point));
  }
  if (!light) {
    return;
  }
  const Vec3 incoming = frame.to_local(light->direction);
  const float side = glm::dot(light->direction, shading_point.normal);
  if (side == 0.0F) {
    return;
  }
  Rgb gain = direct_light(path.throughput, bsdf.eval(incoming, side > 0.0F), *light,
                          light_samples_weighed_ * light->pdf);
  if (gain == Rgb(0.0F)) {
    return;
  }
  const bool is_beyond = side < 0.0F;
  Ray shadow_ray;
  shadow_ray.key = numbers.shadow_key;
  shadow_ray.origin = is_beyond ? point.origin_beyond() : point.origin;
  if (side > 0.0F && glm::dot(light->direction, point.geometric_normal) <= 0.0F &&
      !lift_origin(hit, point.geometric_normal, shadow_ray.origin)) {
    return;
  }
  shadow_ray.direction = shadow_direction(*light, point.position, shadow_ray.origin);
  shadow_ray.t_max = light->t_max;
  const Rgb absorption = is_beyond
                             ? absorption_beyond(path, point.reflectance, object.absorption_per_m)
                             : path.absorption_per_m;
  gain *= transmittance(absorption, glm::length(shadow_ray.direction) * shadow_ray.t_max);
  gain = glm::min(gain, Rgb(settings_.largest_light_sample));
  if (finite(path.job, gain, shadow_ray.direction)) {
    if (notes_.light_outcomes != nullptr) {
      notes_.light_outcomes->back().gain = max_component(gain) / max_component(path.throughput);
      pending_outcomes_.push_back(notes_.light_outcomes->size() - 1);
    }
    pending_.push_back({.job = path.job,
                        .radiance = gain,
                        .is_distant = !light->is_delta && std::isinf(light->t_max)});
    shadow_rays_.add(shadow_ray.origin, shadow_ray.direction, shadow_ray.t_max, shadow_ray.key);
  }
}

float BlockTracer::distant_weight_beyond(const Path& path, const TracedObject& object) const {
  if (path.pdf == certain && object.refracts) {
    return path.distant_weight;
  }
  // Inside an absorbing solid, no light sample reaches infinity.
  if (!object.refracts || path.absorption_per_m != Rgb(0.0F) ||
      !traced_.lights.is_in_sun(path.ray.direction)) {
    return 1.0F;
  }
  const float light_pdf = traced_.lights.distant_light(path.shading_point, path.ray.direction).pdf;
  return power_heuristic(path.pdf, light_samples_weighed_ * light_pdf);
}

bool BlockTracer::survives_roulette(Path& path, float u) const {
  const float brightest = max_component(path.throughput) / path.radiance_scale;
  const float survives = survival(brightest);
  if (vertex_ <= settings_.vertices_before_roulette || survives >= 1.0F) {
    return brightest > 0.0F;
  }
  path.throughput /= survives;
  return u < survives;
}

}  // namespace foveola
