#include "renderer/trace/coat_albedo.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "renderer/trace/ggx.h"

namespace foveola {
namespace {

constexpr int steps = 64;  ///< along the roughness, and along the square root of the cosine
constexpr int nodes = steps + 1;

/// Unit vectors in the middle of equal sectors of half the circle.
std::vector<Vec2> half_circle(int sectors) {
  std::vector<Vec2> vectors;
  for (int i = 0; i < sectors; ++i) {
    const double azimuth = std::numbers::pi * (i + 0.5) / sectors;
    vectors.emplace_back(std::cos(azimuth), std::sin(azimuth));
  }
  return vectors;
}

/// The expected weight of a sampled reflection, by the midpoint rule. The sampling is symmetric, so
/// half of the azimuths are enough.
float integrate_albedo(float cosine, const Ggx& ggx, const std::vector<Vec2>& azimuths) {
  constexpr int heights = 48;
  const Vec3 outgoing(std::sqrt(1.0F - cosine * cosine), 0.0F, cosine);
  const float lambda_outgoing = ggx.lambda(outgoing);
  double sum = 0.0;
  for (int i = 0; i < heights; ++i) {
    const float u = (static_cast<float>(i) + 0.5F) / heights;
    for (const Vec2& azimuth : azimuths) {
      const Vec3 normal = ggx.visible_normal(outgoing, azimuth, u);
      const float cosine_normal = glm::dot(outgoing, normal);
      const Vec3 incoming = 2.0F * cosine_normal * normal - outgoing;
      if (incoming.z > 0.0F) {
        const float fresnel =
            dielectric_f0 + (1.0F - dielectric_f0) * schlick_weight(cosine_normal);
        sum += fresnel * (1.0F + lambda_outgoing) / (1.0F + lambda_outgoing + ggx.lambda(incoming));
      }
    }
  }
  return static_cast<float>(sum / (heights * static_cast<double>(azimuths.size())));
}

/// The exact integral of 2 E(c) c dc where E is linear in t = sqrt(c) between the nodes: with
/// c = t^2 that is 4 E(t) t^3 dt.
float mean_of(const float* albedos) {
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t0 = static_cast<double>(i) / steps;
    const double t1 = static_cast<double>(i + 1) / steps;
    const double slope = (albedos[i + 1] - albedos[i]) * static_cast<double>(steps);
    const double intercept = albedos[i] - slope * t0;
    sum += intercept * (std::pow(t1, 4) - std::pow(t0, 4)) +
           slope * 0.8 * (std::pow(t1, 5) - std::pow(t0, 5));
  }
  return static_cast<float>(sum);
}

/// A position among the nodes: the one below, and how far it is to the next.
struct NodePosition {
  int below;
  float fraction;

  explicit NodePosition(float unit)
      : below(std::min(static_cast<int>(unit * steps), steps - 1)),
        fraction(unit * steps - static_cast<float>(below)) {}
};

}  // namespace

CoatAlbedo::CoatAlbedo(const Workers& workers) : albedos_(nodes * nodes), means_(nodes) {
  const std::vector<Vec2> azimuths = half_circle(16);
  workers.for_each_block(nodes, 1, [&](std::size_t row, std::size_t) {
    const Ggx ggx = ggx_of_roughness(static_cast<float>(row) / steps);
    float* albedos = &albedos_[row * nodes];
    for (int c = 0; c < nodes; ++c) {
      const float t = static_cast<float>(c) / steps;
      constexpr float smallest_cosine = 1e-4F;
      albedos[c] = integrate_albedo(std::max(t * t, smallest_cosine), ggx, azimuths);
    }
    means_[row] = mean_of(albedos);
  });
}

CoatAlbedo::Row CoatAlbedo::row(float roughness) const {
  assert(roughness >= 0.0F && roughness <= 1.0F);
  const NodePosition position(roughness);
  const auto below = static_cast<std::size_t>(position.below);
  Row row;
  row.smoother_ = &albedos_[below * nodes];
  row.rougher_ = row.smoother_ + nodes;
  row.rougher_weight_ = position.fraction;
  row.mean_ = means_[below] + position.fraction * (means_[below + 1] - means_[below]);
  return row;
}

float CoatAlbedo::Row::at(float cosine) const {
  const NodePosition position(std::sqrt(cosine));
  const auto along = [&](const float* albedos) {
    return albedos[position.below] +
           position.fraction * (albedos[position.below + 1] - albedos[position.below]);
  };
  const float smoother = along(smoother_);
  return smoother + rougher_weight_ * (along(rougher_) - smoother);
}

}  // namespace foveola
