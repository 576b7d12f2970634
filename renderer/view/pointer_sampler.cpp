#include "renderer/view/pointer_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/view/radial_distribution.h"
#include "renderer/view/sample_block.h"

namespace foveola {

PointerSampler::PointerSampler(double radius_deg, double cutoff_deg,
                               const std::optional<Vec3>& fixed)
    : radius_deg_(radius_deg),
      cutoff_deg_(cutoff_deg),
      share_(-std::expm1(-0.5 * std::pow(cutoff_deg / radius_deg, 2))),
      fixed_(fixed) {}

void PointerSampler::aim(const Aim& aim) {
  around_ = Frame(fixed_.value_or(glm::normalize(aim.pointer.value_or(aim.gaze))));
}

void PointerSampler::sample(std::span<const Vec2> points, std::span<ViewSample> samples) const {
  constexpr double turns_per_degree = 1.0 / 360.0;
  const double scale = radius_deg_ * turns_per_degree;
  const double cutoff = cutoff_deg_ * turns_per_degree;
  // The radius of a two-dimensional Gaussian has an inverse in closed form (Box and Muller 1958).
  // In double: the rare samples far away depend on the last bits of u.
  const auto polar = [&](const Vec2& point) {
    const double eccentricity = scale * std::sqrt(-2.0 * std::log1p(-share_ * point.x));
    return Vec2(static_cast<float>(std::min(eccentricity, cutoff)), point.y);
  };
  sample_around(around_, points, point_by_point(polar), samples);
}

double PointerSampler::density_per_sr(const Vec3& direction) const {
  const double e = degrees(angle_between(direction, around_.normal));
  if (e > cutoff_deg_) {
    return 0.0;
  }
  const double t = e / radius_deg_;
  const double per_square_degree =
      std::exp(-0.5 * t * t) / (2.0 * std::numbers::pi * radius_deg_ * radius_deg_ * share_);
  return foveola::density_per_sr(per_square_degree, e, EccentricityMeasure::planar);
}

}  // namespace foveola
