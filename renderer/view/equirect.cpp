#include "renderer/view/equirect.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foveola {
namespace {

constexpr double pi = std::numbers::pi;

/// The largest float below 1.
constexpr float below_one = 0x1.fffffep-1F;

}  // namespace

Vec2 equirect_from_direction(const Vec3& direction) {
  const float azimuth = std::atan2(direction.x, -direction.z);
  const float elevation = std::atan2(direction.y, std::hypot(direction.x, direction.z));
  const float u = azimuth * static_cast<float>(0.5 / pi) + 0.5F;
  const float v = 0.5F - elevation * static_cast<float>(1.0 / pi);
  return {std::clamp(u >= 1.0F ? u - 1.0F : u, 0.0F, below_one), std::clamp(v, 0.0F, 1.0F)};
}

Vec3 direction_from_equirect(const Vec2& image) {
  const float azimuth = (image.x - 0.5F) * static_cast<float>(2.0 * pi);
  const float polar = image.y * static_cast<float>(pi);
  const float horizontal = std::max(std::sin(polar), 0.0F);  // pi, rounded, lies beyond the pole
  return {horizontal * std::sin(azimuth), std::cos(polar), -horizontal * std::cos(azimuth)};
}

double equirect_area_per_sr(const Vec3& direction) {
  const DVec3 d(direction);
  const double cos_elevation = std::hypot(d.x, d.z) / glm::length(d);
  return 1.0 / (2.0 * pi * pi * cos_elevation);
}

}  // namespace foveola
