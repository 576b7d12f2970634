#include "renderer/trace/lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace foveola {
namespace {

/// The area of the disc that the scene's bounding sphere covers.
double cross_section(const Scene& scene) {
  const Bounds bounds = scene.bounds();
  const double radius = 0.5 * glm::length(DVec3(bounds.upper) - DVec3(bounds.lower));
  return std::numbers::pi * radius * radius;
}

}  // namespace

Lights::Lights(const Scene& scene, std::size_t most_in_table)
    : suns_(scene), local_(scene, most_in_table) {
  if (scene.environment) {
    environment_.emplace(*scene.environment);
    if (!(environment_->total_luminance() > 0.0)) {
      environment_.reset();
    }
  }
  empty_ = !environment_ && suns_.empty() && local_.empty() && !local_.has_unlisted();
  set_probabilities(scene);
}

void Lights::set_probabilities(const Scene& scene) {
  struct Kind {
    bool exists;
    double power;
    float* probability;
  };
  const double area = cross_section(scene);
  const std::array<Kind, 3> kinds{
      {{environment_.has_value(), environment_ ? area * environment_->total_luminance() : 0.0,
        &environment_probability_},
       {!suns_.empty(), area * suns_.irradiance(), &suns_probability_},
       {!local_.empty(), local_.power(), &local_probability_}}};
  double count = 0.0;
  double power = 0.0;
  for (const Kind& kind : kinds) {
    count += kind.exists ? 1.0 : 0.0;
    power += kind.exists ? kind.power : 0.0;
  }
  for (const Kind& kind : kinds) {
    if (kind.exists) {
      const bool is_known = power > 0.0 && std::isfinite(power);
      const double share = is_known ? kind.power / power : 1.0 / count;
      *kind.probability = static_cast<float>(0.5 / count + 0.5 * share);
    }
  }
}

std::optional<LightSample> Lights::sample(const Receiver& receiver, float u_kind,
                                          const Vec2& u_choice, const Vec2& u) const {
  // Rounding may leave a u_kind above the sum, which belongs to the last kind there is.
  const bool only_distant = local_.empty();
  if (environment_ && (u_kind < environment_probability_ || (only_distant && suns_.empty()))) {
    const EnvironmentLight::Sample sky = environment_->sample(u);
    return sample_distant(receiver, sky.direction, sky.light, {});
  }
  if (!suns_.empty() && (u_kind < environment_probability_ + suns_probability_ || only_distant)) {
    return sample_suns(receiver, u_choice, u);
  }
  return only_distant ? std::nullopt : sample_local(receiver, u_choice, u);
}

std::optional<LightSample> Lights::sample_local(const Receiver& receiver, const Vec2& u_choice,
                                                const Vec2& u) const {
  const auto sample = local_.sample(receiver, u_choice, u);
  if (!sample) {
    return std::nullopt;
  }
  const float distance = glm::length(sample->to_light);
  if (!(distance > 0.0F)) {
    return std::nullopt;
  }
  LightSample light{.direction = sample->to_light / distance,
                    .pdf = local_probability_ * sample->pdf,
                    .radiance = sample->radiance,
                    .is_delta = sample->is_delta,
                    .shadow_ray = {}};
  light.shadow_ray.origin = receiver.position;
  light.shadow_ray.direction = sample->to_light;
  light.shadow_ray.t_max = 1.0F;
  return light;
}

std::optional<LightSample> Lights::sample_suns(const Receiver& receiver, const Vec2& u_choice,
                                               const Vec2& u) const {
  const Suns::Sample sample = suns_.sample(u_choice, u);
  if (!sample.is_delta) {
    const DistantLight sky = environment_ ? environment_->at(sample.direction) : DistantLight{};
    return sample_distant(receiver, sample.direction, sky, sample.sun);
  }
  LightSample light{.direction = sample.direction,
                    .pdf = suns_probability_ * sample.probability,
                    .radiance = sample.irradiance,
                    .is_delta = true,
                    .shadow_ray = {}};
  light.shadow_ray.origin = receiver.position;
  light.shadow_ray.direction = sample.direction;
  return light;
}

std::optional<LightSample> Lights::sample_distant(const Receiver& receiver, const Vec3& direction,
                                                  const DistantLight& sky, Sun known) const {
  const DistantLight distant = with_suns(sky, direction, known);
  if (!(distant.pdf > 0.0F)) {
    return std::nullopt;
  }
  LightSample light{
      .direction = direction, .pdf = distant.pdf, .radiance = distant.radiance, .shadow_ray = {}};
  light.shadow_ray.origin = receiver.position;
  light.shadow_ray.direction = direction;
  return light;
}

float Lights::triangle_pdf(const Receiver& receiver, const Hit& hit, float distance,
                           float cosine) const {
  return local_probability_ > 0.0F
             ? local_probability_ * local_.triangle_pdf(receiver, hit, distance, cosine)
             : 0.0F;
}

DistantLight Lights::with_suns(const DistantLight& sky, const Vec3& direction, Sun known) const {
  const DistantLight both{.radiance = sky.radiance, .pdf = environment_probability_ * sky.pdf};
  if (suns_.empty()) {
    return both;
  }
  const DistantLight suns = suns_.at(direction, known);
  return {.radiance = both.radiance + suns.radiance,
          .pdf = both.pdf + suns_probability_ * suns.pdf};
}

DistantLight Lights::distant_light(const Vec3& direction) const {
  return with_suns(environment_ ? environment_->at(direction) : DistantLight{}, direction, {});
}

}  // namespace foveola
