#include "renderer/trace/coat_albedo.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/trace/ggx.h"

namespace foveola {
namespace {

constexpr int steps = 32;  ///< along the roughness, and along the square root of the cosine
constexpr int nodes = steps + 1;

/// The expected weight of a sampled reflection, by the midpoint rule over the unit square.
float integrate_albedo(float cosine, const Ggx& ggx) {
  constexpr int elevations = 48;
  constexpr int azimuths = 16;  // half the circle; the other half is its mirror image
  const Vec3 outgoing(std::sqrt(1.0F - cosine * cosine), 0.0F, cosine);
  const float lambda_outgoing = ggx.lambda(outgoing);
  double sum = 0.0;
  for (int e = 0; e < elevations; ++e) {
    for (int a = 0; a < azimuths; ++a) {
      const Vec2 u((static_cast<float>(a) + 0.5F) / (2.0F * azimuths),
                   (static_cast<float>(e) + 0.5F) / elevations);
      const Vec3 normal = ggx.sample_visible_normal(outgoing, u);
      const float cosine_normal = glm::dot(outgoing, normal);
      const Vec3 incoming = 2.0F * cosine_normal * normal - outgoing;
      if (incoming.z > 0.0F) {
        const float fresnel =
            dielectric_f0 + (1.0F - dielectric_f0) * schlick_weight(cosine_normal);
        sum += fresnel * (1.0F + lambda_outgoing) / (1.0F + lambda_outgoing + ggx.lambda(incoming));
      }
    }
  }
  return static_cast<float>(sum / (elevations * azimuths));
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

CoatAlbedo::CoatAlbedo() {
  albedos_.reserve(nodes * nodes);
  for (int r = 0; r < nodes; ++r) {
    const Ggx ggx = ggx_of_roughness(static_cast<float>(r) / steps);
    for (int c = 0; c < nodes; ++c) {
      const float t = static_cast<float>(c) / steps;
      constexpr float smallest_cosine = 1e-4F;
      albedos_.push_back(integrate_albedo(std::max(t * t, smallest_cosine), ggx));
    }
    means_.push_back(mean_of(&albedos_[static_cast<std::size_t>(r) * nodes]));
  }
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
