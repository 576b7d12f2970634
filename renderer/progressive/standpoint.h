// Where to stand in a scene whose file has no camera.
#pragma once

#include <string>

#include "renderer/base/angles.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/ray_scene.h"

namespace foveola {

struct Standpoint {
  Vec3 position{0.0F};  ///< in the scene's world
  AzimuthElevation heading;
  std::string reason;  ///< in words that follow "seen from (x, y, z), "
};

/// The middle of the scene's bounds, looking along -Z, unless nothing is seen from there: in the
/// inside of a closed object, or on a flat scene. Then in front of the bounds (towards +Z, where
/// glTF's models look, and to the side of a flat scene's surface), looking at their middle, so far
/// away that they fit into a cone of 60 degrees.
///
/// The middle counts as the inside of a closed object where at least four fifths of the rays from
/// it, evenly in all directions, meet something, at least four fifths of these meet the back of a
/// triangle by its winding, and no point or spot light is in sight. This is a guess. It takes an
/// empty room whose walls face outwards and that is not lit from within for a closed object, and
/// stays within an object whose triangles face inwards. In front of the bounds something may stand
/// in the way of what was meant to be seen.
Standpoint choose_standpoint(const Scene& scene, const RayScene& rays);

}  // namespace foveola
