// Directions and the 360-degree equirectangular image.
#pragma once

#include "renderer/base/vec.h"

namespace foveola {

/// A continuous image position: u in [0, 1) left to right, azimuth (u - 1/2) * 2 pi from -Z towards
/// +X; v in [0, 1] top to bottom, elevation (1/2 - v) * pi.
Vec2 equirect_from_direction(const Vec3& direction);

/// The unit direction of an image position; u may lie outside [0, 1) and wraps.
Vec3 direction_from_equirect(const Vec2& image);

/// Image area per steradian at `direction`, for the unit image [0, 1)^2: 1 / (2 pi^2
/// cos(elevation)).
double equirect_area_per_sr(const Vec3& direction);

}  // namespace foveola
