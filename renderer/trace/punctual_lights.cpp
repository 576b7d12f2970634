#include "renderer/trace/punctual_lights.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "renderer/trace/direction_cone.h"

namespace foveola {
namespace {

using std::numbers::pi_v;

/// Spheres whose sine of half the angle that they fill, squared, is less count as points.
constexpr float smallest_squared_sine = 1e-10F;

/// The narrowest rim of a spot, in cosines: KHR_lights_punctual's.
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

/// What a spot lets through towards `direction`, of unit length; 1 for points.
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

/// The integral over the cosine of the angle to a spot's direction, and so over the solid angle
/// but for a factor of 2 pi, of what the spot lets through.
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

/// A sample of a light's sphere, whose centre is at distance * to_centre. intensity: towards the
/// place.
LocalLightSample sample_sphere(float radius, const Vec3& to_centre, float distance,
                               const Rgb& intensity, const Vec2& u) {
  const Rgb radiance = intensity / (pi_v<float> * radius * radius);
  const float ratio = radius / distance;
  if (ratio < 1.0F) {
    const DirectionCone cone = DirectionCone::with_sine_squared(to_centre, ratio * ratio);
    const auto drawn = cone.sample(u);
    const float half_chord = std::sqrt(std::max(0.0F, ratio * ratio - drawn.sine_squared));
    return {.to_light = distance * (drawn.cosine - half_chord) * drawn.direction,
            .pdf = 1.0F / cone.solid_angle(),
            .radiance = radiance,
            .is_delta = true};
  }
  const DirectionCone all_around{to_centre, 2.0F};
  const auto drawn = all_around.sample(u);
  const float off = distance / radius;
  const float half_chord = std::sqrt(std::max(0.0F, 1.0F - off * off * drawn.sine_squared));
  return {.to_light = radius * (off * drawn.cosine + half_chord) * drawn.direction,
          .pdf = 1.0F / all_around.solid_angle(),
          .radiance = radiance,
          .is_delta = true};
}

}  // namespace

PunctualLights::PunctualLights(const Scene& scene) {
  std::copy_if(scene.lights.begin(), scene.lights.end(), std::back_inserter(lights_), shines);
  for (PunctualLight& light : lights_) {
    if (!std::isfinite(light.radius_m) || light.radius_m < 0.0F) {
      light.radius_m = 0.0F;
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
  const PunctualLight& source = lights_[light];
  const Vec3 to_centre = source.position - place;
  const float distance = glm::length(to_centre);
  const float radius = source.radius_m;
  if (!(distance > 0.0F) && !(radius > 0.0F)) {
    return std::nullopt;
  }
  const Vec3 direction = distance > 0.0F ? to_centre / distance : -source.direction;
  const float factor = cone_factor(source, -direction);
  if (!(factor > 0.0F)) {
    return std::nullopt;
  }
  const Rgb intensity = factor * source.intensity;
  const bool is_sphere = radius * radius > smallest_squared_sine * distance * distance;
  const LocalLightSample sample =
      is_sphere ? sample_sphere(radius, direction, distance, intensity, u)
                : LocalLightSample{.to_light = to_centre,
                                   .pdf = 1.0F,
                                   .radiance = intensity / (distance * distance),
                                   .is_delta = true};
  return is_finite(sample.radiance) ? std::optional(sample) : std::nullopt;
}

}  // namespace foveola
