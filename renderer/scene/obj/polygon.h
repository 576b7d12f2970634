// Polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

/// The largest polygon that is not convex: each of its triangles is sought among all its corners.
constexpr std::size_t max_concave_corners = 4096;

/// Twice the polygon's area, along the normal of its front, which sees it turn counter-clockwise
/// (Newell's method: no corner needs to be convex). It must have a corner.
DVec3 area_vector(std::span<const Vec3> corners);

/// The triangles, counted by corner and turning as the polygon does, of a flat simple polygon; of
/// three corners or more always two fewer than corners. A convex polygon becomes a fan around its
/// first corner, any other is cut ear by ear (Meisters 1975, "Polygons Have Ears"). One that
/// intersects itself, is not flat or not finite gets triangles too, which may overlap. Throws
/// std::length_error if it has more than `max_concave_corners` and is not convex.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace foveola
