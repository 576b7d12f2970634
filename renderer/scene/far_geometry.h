// Leaves out of a scene what stands farther away than rays can be traced.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// The largest coordinate in metres that rays are traced at. The way between any two such places is
/// within Embree's limit of 1.844e18.
inline constexpr float max_coordinate_m = 9e17F;

/// Whether no coordinate is beyond the limit, or not a number.
bool is_traceable(const Vec3& position);

/// Drops triangles, instances and lights with a position that is not traceable, with warnings.
void drop_far_parts(Scene& scene, Warnings& warnings);

}  // namespace foveola
