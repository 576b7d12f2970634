// Triangulates polygons.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

/// Maximum number of corners of a concave polygon: the search for each triangle visits all corners.
constexpr std::size_t max_concave_corners = 4096;

/// Twice the polygon's area along its front normal, about which the corners run counter-clockwise
/// (Newell's method: no corner needs to be convex). At least one corner.
DVec3 area_vector(std::span<const Vec3> corners);

/// Triangulates a flat simple polygon into corner indices with the polygon's winding: always two
/// fewer triangles than corners, from three corners. A convex polygon becomes a fan around its
/// first corner; any other is cut by ears (Meisters 1975, "Polygons Have Ears"). A polygon that
/// intersects itself, is not flat or not finite gets triangles too, which may overlap. Throws
/// std::length_error if it is concave with more than `max_concave_corners` corners.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace foveola
