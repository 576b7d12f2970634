#include "renderer/trace/lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foveola {
namespace {

/// The power of the environment that falls on the scene's bounding sphere.
double environment_power(const EnvironmentLight& environment, const Bounds& bounds) {
  const double radius = 0.5 * glm::length(DVec3(bounds.upper) - DVec3(bounds.lower));
  return environment.total_luminance() * std::numbers::pi * radius * radius;
}

}  // namespace

Lights::Lights(const Scene& scene) : triangles_(scene) {
  if (scene.environment) {
    environment_.emplace(*scene.environment);
    if (!(environment_->total_luminance() > 0.0)) {
      environment_.reset();
    }
  }
  if (!environment_) {
    return;
  }
  if (triangles_.empty()) {
    environment_probability_ = 1.0F;
    return;
  }
  const double power = environment_power(*environment_, scene.bounds());
  environment_probability_ =
      static_cast<float>(std::clamp(power / (power + triangles_.power()), 0.25, 0.75));
}

std::optional<LightSample> Lights::sample(const Vec3& receiver, float u_kind, const Vec2& u_choice,
                                          const Vec2& u) const {
  return u_kind < environment_probability_ ? sample_environment(receiver, u)
                                           : sample_triangle(receiver, u_choice, u);
}

std::optional<LightSample> Lights::sample_triangle(const Vec3& receiver, const Vec2& u_choice,
                                                   const Vec2& u) const {
  const auto sample = triangles_.sample(receiver, u_choice, u);
  if (!sample) {
    return std::nullopt;
  }
  const Vec3 to_light = sample->point - receiver;
  LightSample light{.direction = glm::normalize(to_light),
                    .pdf = (1.0F - environment_probability_) * sample->pdf,
                    .radiance = sample->radiance,
                    .shadow_ray = {}};
  light.shadow_ray.origin = receiver;
  light.shadow_ray.direction = to_light;
  light.shadow_ray.t_max = 1.0F;
  return light;
}

std::optional<LightSample> Lights::sample_environment(const Vec3& receiver, const Vec2& u) const {
  const EnvironmentLight::Sample sample = environment_->sample(u);
  if (!(sample.pdf > 0.0F)) {
    return std::nullopt;
  }
  LightSample light{.direction = sample.direction,
                    .pdf = environment_probability_ * sample.pdf,
                    .radiance = environment_->radiance(sample.direction),
                    .shadow_ray = {}};
  light.shadow_ray.origin = receiver;
  light.shadow_ray.direction = sample.direction;
  return light;
}

float Lights::triangle_pdf(const Hit& hit, float distance, float cosine) const {
  return (1.0F - environment_probability_) * triangles_.area_pdf(hit.object) * distance * distance /
         cosine;
}

Rgb Lights::environment_radiance(const Vec3& direction) const {
  return environment_ ? environment_->radiance(direction) : Rgb(0.0F);
}

float Lights::environment_pdf(const Vec3& direction) const {
  return environment_probability_ * environment_->pdf(direction);
}

}  // namespace foveola
