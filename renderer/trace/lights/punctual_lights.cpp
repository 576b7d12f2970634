#include "renderer/trace/lights/punctual_lights.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace foveola {
namespace {

using std::numbers::pi_v;

/// Spheres with a smaller squared sine of half the subtended angle count as points.
constexpr float smallest_squared_sine = 1e-10F;

/// The minimum width of a spot's rim, in cosines: KHR_lights_punctual's.
constexpr float narrowest_rim = 1e-3F;

bool shines(const PunctualLight& light) {
  if (!is_finite(light.position) || !is_finite(light.intensity) ||
      !(luminance(light.intensity) > 0.0F)) {
    return false;
  }
  const float squared_length = glm::dot(light.direction, light.direction);
  return light.kind == PunctualLight::Kind::point ||
         (light.kind == PunctualLight::Kind::spot && std::abs(squared_length - 1.0F) < 1e-3F &&
          std::isfinite(light.inner_cone_rad) && std::isfinite(light.outer_cone_rad));
}

float rim_of(const PunctualLight& light) {
  return std::max(narrowest_rim, std::cos(light.inner_cone_rad) - std::cos(light.outer_cone_rad));
}

/// Angular factor of a spot towards `direction`, of unit length; 1 for points.
float cone_factor(const PunctualLight& light, const Vec3& direction) {
  if (light.kind == PunctualLight::Kind::point) {
    return 1.0F;
  }
  const float cosine = glm::dot(light.direction, direction);
  const float share = (cosine - std::cos(light.outer_cone_rad)) / rim_of(light);
  const float t = std::clamp(share, 0.0F, 1.0F);
  switch (light.cone_edge) {
    case PunctualLight::ConeEdge::smooth:
      return t * t * (3.0F - 2.0F * t);
    case PunctualLight::ConeEdge::smooth_times_cosine:
      return t * t * (3.0F - 2.0F * t) * std::max(0.0F, cosine);
    case PunctualLight::ConeEdge::squared:
      break;
  }
  return t * t;
}

/// Integral of a spot's factor over the cosine of the angle to its direction: the solid angle
/// integral divided by 2 pi.
double cone_integral(const PunctualLight& light) {
  const double rim = rim_of(light);
  const double outer = std::cos(static_cast<double>(light.outer_cone_rad));
  const double inside = std::max(0.0, 1.0 - outer - rim);
  switch (light.cone_edge) {
    case PunctualLight::ConeEdge::smooth:
      return inside + rim / 2.0;
    case PunctualLight::ConeEdge::smooth_times_cosine:
      return inside * (1.0 + outer + rim) / 2.0 + rim * (outer / 2.0 + 0.35 * rim);
    case PunctualLight::ConeEdge::squared:
      break;
  }
  return inside + rim / 3.0;
}

/// A light as seen from a place.
struct View {
  Vec3 direction;  ///< unit length, to its centre
  float distance;  ///< of that
  Rgb intensity;   ///< towards the place
  float radius;
  bool is_sphere;  ///< whether it does not count as a point

  bool is_from_inside() const { return !(radius / distance < 1.0F); }
  Rgb radiance() const { return intensity / (pi_v<float> * radius * radius); }
  /// The directions to the sphere.
  DirectionCone cone() const {
    const float ratio = radius / distance;
    return is_from_inside() ? DirectionCone{direction, 2.0F}
                            : DirectionCone::with_sine_squared(direction, ratio * ratio);
  }
};

/// nullopt if the light does not reach the place.
std::optional<View> view_from(const Vec3& place, const PunctualLight& light) {
  const Vec3 to_centre = light.position - place;
  const float distance = glm::length(to_centre);
  const float radius = light.radius_m;
  if (!(distance > 0.0F) && !(radius > 0.0F)) {
    return std::nullopt;
  }
  const Vec3 direction = distance > 0.0F ? to_centre / distance : -light.direction;
  const float factor = cone_factor(light, -direction);
  if (!(factor > 0.0F)) {
    return std::nullopt;
  }
  return View{.direction = direction,
              .distance = distance,
              .intensity = factor * light.intensity,
              .radius = radius,
              .is_sphere = radius * radius > smallest_squared_sine * distance * distance};
}

LocalLightSample sample_sphere(const View& view, const Vec2& u) {
  const DirectionCone cone = view.cone();
  const auto drawn = cone.sample(u);
  float distance = 0.0F;
  if (view.is_from_inside()) {
    const float off = view.distance / view.radius;
    const float half_chord = std::sqrt(std::max(0.0F, 1.0F - off * off * drawn.sine_squared));
    distance = view.radius * (off * drawn.cosine + half_chord);
  } else {
    const float ratio = view.radius / view.distance;
    const float half_chord = std::sqrt(std::max(0.0F, ratio * ratio - drawn.sine_squared));
    distance = view.distance * (drawn.cosine - half_chord);
  }
  return {.to_light = distance * drawn.direction,
          .pdf = 1.0F / cone.solid_angle(),
          .radiance = view.radiance(),
          .is_delta = false};
}

}  // namespace

PunctualLights::PunctualLights(const Scene& scene) {
  std::ranges::copy_if(scene.lights, std::back_inserter(lights_), shines);
  for (PunctualLight& light : lights_) {
    if (!std::isfinite(light.radius_m) || light.radius_m < 0.0F) {
      light.radius_m = 0.0F;
    }
  }
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    if (lights_[i].radius_m > 0.0F) {
      spheres_.push_back(i);
    }
  }
}

double PunctualLights::power(std::size_t light) const {
  const PunctualLight& source = lights_[light];
  const double intensity = luminance(source.intensity);
  if (source.kind == PunctualLight::Kind::point) {
    return 4.0 * std::numbers::pi * intensity;
  }
  return 2.0 * std::numbers::pi * intensity * cone_integral(source);
}

LightBounds PunctualLights::bounds(std::size_t light) const {
  const PunctualLight& source = lights_[light];
  const bool is_point = source.kind == PunctualLight::Kind::point;
  const double inner = std::min(source.inner_cone_rad, source.outer_cone_rad);
  const Vec3 radius(source.radius_m);
  return {.box = {.lower = source.position - radius, .upper = source.position + radius},
          .axis = DVec3(source.direction),
          .spread_rad = is_point ? std::numbers::pi : inner,
          .falloff_rad = is_point ? 0.5 * std::numbers::pi : source.outer_cone_rad - inner,
          .two_sided = false,
          .intensity = luminance(source.intensity)};
}

std::optional<LocalLightSample> PunctualLights::sample(std::size_t light, const Vec3& place,
                                                       const Vec2& u) const {
  const std::optional<View> view = view_from(place, lights_[light]);
  if (!view) {
    return std::nullopt;
  }
  const LocalLightSample sample =
      view->is_sphere
          ? sample_sphere(*view, u)
          : LocalLightSample{.to_light = lights_[light].position - place,
                             .pdf = 1.0F,
                             .radiance = view->intensity / (view->distance * view->distance),
                             .is_delta = true};
  return is_finite(sample.radiance) ? std::optional(sample) : std::nullopt;
}

std::optional<PunctualLights::SphereHit> PunctualLights::hit(std::size_t light, const Vec3& origin,
                                                             const Vec3& direction) const {
  const PunctualLight& source = lights_[light];
  const Vec3 to_centre = source.position - origin;
  const float along = glm::dot(to_centre, direction);
  const Vec3 aside = to_centre - along * direction;
  const float squared_half_chord = source.radius_m * source.radius_m - glm::dot(aside, aside);
  if (!(squared_half_chord >= 0.0F)) {
    return std::nullopt;
  }
  const std::optional<View> view = view_from(origin, source);
  if (!view) {
    return std::nullopt;
  }
  const float half_chord = std::sqrt(squared_half_chord);
  const SphereHit met{.t = view->is_from_inside() ? along + half_chord : along - half_chord,
                      .radiance = view->radiance(),
                      .pdf = view->is_sphere ? 1.0F / view->cone().solid_angle()
                                             : std::numeric_limits<float>::infinity()};
  return met.t > 0.0F && is_finite(met.radiance) ? std::optional(met) : std::nullopt;
}

LaneMask PunctualLights::may_hit(const Vec3s& origin, const Vec3s& direction) const {
  LaneMask lanes{};
  for (const std::size_t light : spheres_) {
    // With a margin for rounding, here and in hit().
    const float squared_radius = 1.01F * lights_[light].radius_m * lights_[light].radius_m;
    const Vec3s to_centre = all_lanes(lights_[light].position) - origin;
    const Floats along = dot(to_centre, direction);
    const Vec3s aside = to_centre - along * direction;
    const Floats squared_distance = dot(to_centre, to_centre);
    lanes |= (dot(aside, aside) <= squared_radius + 1e-10F * squared_distance) &
             ((along > 0.0F) | (squared_distance <= squared_radius));
  }
  return lanes;
}

}  // namespace foveola
