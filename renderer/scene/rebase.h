// Scenes that stand far from their file's origin are moved to their own: floats are finest near 0.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// The origin for a scene with these bounds in its file's world: 0, or, where the bounds' middle is
/// further away than eight times their half diagonal, a point near that middle whose subtraction
/// rounds nothing that floats near the middle hold.
DVec3 origin_for(const DVec3& lower, const DVec3& upper);

/// Moves everything in a scene that has origin 0 to the origin for its bounds.
void rebase(Scene& scene);

}  // namespace foveola
