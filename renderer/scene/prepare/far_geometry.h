// Removes the parts of a scene beyond the coordinates at which rays can be traced.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// Maximum coordinate of traceable geometry, in metres. The distance between any two such places is
/// within Embree's limit of 1.844e18.
inline constexpr float max_coordinate_m = 9e17F;

/// Whether all coordinates are within the limit, and none is NaN.
bool is_traceable(const Vec3& position);

/// Drops triangles, instances and lights with a position that is not traceable, with warnings.
void drop_far_parts(Scene& scene, Warnings& warnings);

}  // namespace foveola
