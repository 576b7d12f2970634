// Chooses a viewpoint for a scene without a camera, and the notes shown with a scene's first view.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/view/viewport.h"

namespace foveola {

struct Standpoint {
  Vec3 position{0.0F};  ///< in the scene's world
  AzimuthElevation heading;
  std::string reason;  ///< follows the words "it is seen "
};

/// A room is seen from within: 1.6 m above its floor, or at half its height if that is unusual for
/// rooms, where there is most free space. The view is towards most depth and objects, tilted down
/// if that shows more. Anything else is seen from outside, with all of it in a picture with
/// `field_of_view`: from the front (+Z, where glTF's models look) and the right, slightly from
/// above. Another side or height is chosen if it shows more front faces or depth; a sheet or a
/// plane is seen from its front. A floor larger than the objects on it may extend beyond the
/// picture.
///
/// A room is a place where at least three fifths of the rays, evenly in all directions, and three
/// quarters of the level ones, hit something, and one of three conditions holds. A point or spot
/// light is visible. Or rays hit mostly front faces from within, and mostly back faces from
/// outside. Or it is 1.9 to 100 m high, nearly all rays hit something, and everywhere at least a
/// tenth of the hits are front faces, as of furniture. This heuristic fails for an empty, unlit
/// room whose walls face outwards, and for a hollow object as large as a room.
///
/// Deterministic. Takes two passes over the vertices and a few thousand rays.
Standpoint choose_standpoint(const Scene& scene, const RayScene& rays,
                             const FieldOfView& field_of_view);

/// Lights a scene without emission from all around, more from above.
void add_studio_light(Scene& scene);

/// One line per missing thing of a scene, geometry or light, with the option that helps at the
/// camera's place. has_studio_light: whether that is the only light.
std::vector<std::string> lacks_of(const Scene& scene, bool camera_is_enclosed,
                                  bool has_studio_light = false);

/// Notes on the viewpoint of a file without a camera: the place, its reason, and how to choose
/// another. One more line if nearly all of the picture is empty, because objects lie too far apart.
std::vector<std::string> notes_on_standpoint(const Scene& scene, const RayScene& rays,
                                             const Standpoint& standpoint,
                                             const FieldOfView& field_of_view);

}  // namespace foveola
