#include "renderer/stability/closed_forms.h"

#include <cmath>
#include <numbers>

namespace foveola {

double polygon_irradiance(std::span<const DVec3> corners, const DVec3& point, const DVec3& normal) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const DVec3 a = glm::normalize(corners[i] - point);
    const DVec3 b = glm::normalize(corners[(i + 1) % corners.size()] - point);
    const DVec3 across = glm::cross(a, b);
    const double sine = glm::length(across);
    if (sine > 0.0) {
      sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(across, normal) / sine;
    }
  }
  return 0.5 * sum;
}

double corner_rectangle_form_factor(double width, double height, double distance) {
  const double a = width / distance;
  const double b = height / distance;
  const double slant_a = std::sqrt(1.0 + a * a);
  const double slant_b = std::sqrt(1.0 + b * b);
  return (a / slant_a * std::atan(b / slant_a) + b / slant_b * std::atan(a / slant_b)) *
         (0.5 * std::numbers::inv_pi);
}

double fresnel_reflectance(double cosine, double eta) {
  const double sine_behind = std::sqrt(1.0 - cosine * cosine) / eta;
  if (sine_behind >= 1.0) {
    return 1.0;
  }
  const double cosine_behind = std::sqrt(1.0 - sine_behind * sine_behind);
  const double across = (cosine - eta * cosine_behind) / (cosine + eta * cosine_behind);
  const double along = (eta * cosine - cosine_behind) / (eta * cosine + cosine_behind);
  return 0.5 * (across * across + along * along);
}

SlabShares slab_shares(const GlassSlab& slab, double cosine) {
  const double sine_inside = std::sqrt(1.0 - cosine * cosine) / slab.ior;
  const double path_m = slab.thickness_m / std::sqrt(1.0 - sine_inside * sine_inside);
  const double passed = std::exp(-slab.attenuation_per_m * path_m);
  const double r = fresnel_reflectance(cosine, slab.ior);
  const double series = (1.0 - r) * (1.0 - r) * passed / (1.0 - r * r * passed * passed);
  return {.transmitted = series, .reflected = r + series * r * passed};
}

}  // namespace foveola
