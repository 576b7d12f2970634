// Maps between directions and positions in the 360-degree equirectangular image.
#pragma once

#include <cmath>
#include <numbers>

#include "renderer/base/turns.h"
#include "renderer/base/vec.h"

namespace foveola {

/// A continuous image position: u in [0, 1) left to right, azimuth (u - 1/2) * 2 pi from -Z towards
/// +X; v in [0, 1] top to bottom, elevation (1/2 - v) * pi. direction need not have unit length.
inline Vec2 equirect_from_direction(const Vec3& direction) {
  const float azimuth = turns_of(direction.x, -direction.z);
  const float horizontal = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  const float elevation = turns_of(direction.y, horizontal);
  const float u = azimuth + 0.5F;
  // Half a turn to the right is the seam, where the image begins.
  return {u >= 1.0F ? 0.0F : u, 0.5F - 2.0F * elevation};
}

/// The unit direction of an image position; u may lie outside [0, 1) and wraps.
inline Vec3 direction_from_equirect(const Vec2& image) {
  const auto [x, minus_z] = sine_cosine_of_turns(image.x - 0.5F);
  const auto [horizontal, y] = sine_cosine_of_turns(0.5F * image.y);
  return {horizontal * x, y, -horizontal * minus_z};
}

/// Angle of a pixel along the horizon in an image of `width` pixels.
inline float pixel_angle_rad(int width) {
  return 2.0F * std::numbers::pi_v<float> / static_cast<float>(width);
}

/// Image area per steradian at `direction`, for the unit image [0, 1)^2: 1 / (2 pi^2
/// cos(elevation)).
double equirect_area_per_sr(const Vec3& direction);

}  // namespace foveola
