// Moves scenes that are far from their file's origin to 0, where floats are finest.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// The origin for a scene with these bounds in its file's world. 0 unless the bounds' centre is
/// further away than eight times their half diagonal; then a point near the centre. Its subtraction
/// is exact for floats near the centre.
DVec3 origin_for(const DVec3& lower, const DVec3& upper);

/// Moves everything in a scene with origin 0 to the origin for its bounds.
void rebase(Scene& scene);

}  // namespace foveola
