#include "renderer/trace/lights/suns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foveola {
namespace {

constexpr float smallest_disc_rad = 5e-4F;

bool is_sun(const PunctualLight& light) {
  return light.kind == PunctualLight::Kind::directional && is_finite(light.intensity) &&
         luminance(light.intensity) > 0.0F &&
         std::abs(glm::dot(light.direction, light.direction) - 1.0F) < 1e-3F;
}

/// 1 - cos(angle) through half the angle, which is exact for small angles.
float one_minus_cosine(float angle_rad) {
  const float sine = std::sin(0.5F * angle_rad);
  return 2.0F * sine * sine;
}

}  // namespace

Suns::Sun::Sun(const PunctualLight& light)
    : irradiance(light.intensity),
      disc{-glm::normalize(light.direction),
           one_minus_cosine(std::min(light.angular_radius_rad, 0.5F * std::numbers::pi_v<float>))},
      is_delta(!(light.angular_radius_rad >= smallest_disc_rad)),
      probability(0.0F) {
  if (!is_delta) {
    const float squared_sine = disc.one_minus_cosine * (2.0F - disc.one_minus_cosine);
    shine.radiance = irradiance / (std::numbers::pi_v<float> * squared_sine);
  }
}

bool Suns::Sun::covers(const Vec3& direction) const {
  // The squared chord between two unit vectors is twice one minus the cosine between them.
  const Vec3 chord = direction - disc.axis;
  return !is_delta && glm::dot(chord, chord) <= 2.0F * disc.one_minus_cosine;
}

Suns::Suns(const Scene& scene, LightSelection selection) {
  std::vector<double> weights;
  double total = 0.0;
  for (const PunctualLight& light : scene.lights) {
    if (is_sun(light)) {
      const double irradiance = luminance(light.intensity);
      suns_.emplace_back(light);
      weights.push_back(selection == LightSelection::uniform ? 1.0 : irradiance);
      irradiance_ += irradiance;
      total += weights.back();
    }
  }
  if (suns_.empty()) {
    return;
  }
  choice_.emplace(weights);
  for (std::size_t i = 0; i < suns_.size(); ++i) {
    Sun& sun = suns_[i];
    sun.probability = static_cast<float>(weights[i] / total);
    sun.shine.pdf = sun.is_delta ? 0.0F : sun.probability / sun.disc.solid_angle();
  }
}

std::size_t Suns::sizeless() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(suns_, [](const Sun& sun) { return sun.is_delta; }));
}

Suns::Sample Suns::sample(const Vec2& u_choice, const Vec2& u) const {
  const std::size_t index = choice_->sample(u_choice);
  const Sun& sun = suns_[index];
  return {.sun = index,
          .direction = sun.is_delta ? sun.disc.axis : sun.disc.sample(u).direction,
          .is_delta = sun.is_delta,
          .probability = sun.probability,
          .irradiance = sun.irradiance};
}

DistantLight Suns::at(const Vec3& direction, std::optional<std::size_t> known) const {
  DistantLight sum;
  for (std::size_t i = 0; i < suns_.size(); ++i) {
    if (known == i || suns_[i].covers(direction)) {
      sum.radiance += suns_[i].shine.radiance;
      sum.pdf += suns_[i].shine.pdf;
    }
  }
  return sum;
}

}  // namespace foveola
