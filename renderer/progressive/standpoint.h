// Where to stand in a scene whose file has no camera, and what a user is told about a scene as it
// is first seen.
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
  std::string reason;  ///< in words that follow "it is seen "
};

/// In a room from within: 1.6 m above its floor, or at half its height if it is lower or higher
/// than rooms for people are, where there is most space around, looking where there is most to see,
/// in depth and in objects, and downwards if there is more to see than straight ahead. Anything
/// else from outside, from where a picture with `field_of_view` has all of it: from the front (+Z,
/// where glTF's models look) and the right, slightly from above; from another side or from further
/// above if that shows more fronts, or deeper; and a sheet or a plane from its front. A floor that
/// is larger than what stands on it need not be in the picture as a whole.
///
/// A room is a place where at least three fifths of the rays, evenly in all directions, and three
/// quarters of the level ones, meet something, and where one of these holds: a point or spot light
/// is in sight; it is mostly fronts of triangles, by their winding, that are seen from within, and
/// mostly backs from outside; or it is 1.9 to 100 m high, nearly all rays meet something, and from
/// all over it at least a tenth of what rays meet are fronts, as of furniture. This is a guess: it
/// takes a room whose walls face outwards for a closed object if it is empty and unlit, and a
/// hollow object as large as a room for a room.
///
/// It is the same for the same scene. It takes two passes over the vertices and a few thousand
/// rays.
Standpoint choose_standpoint(const Scene& scene, const RayScene& rays,
                             const FieldOfView& field_of_view);

/// Lights a scene in which nothing shines evenly from all around, and more from above.
void add_studio_light(Scene& scene);

/// One line each for what a scene lacks: geometry, or light; the option that mends it is the one
/// that helps where the camera stands. has_studio_light: whether only that lights it.
std::vector<std::string> lacks_of(const Scene& scene, bool camera_is_enclosed,
                                  bool has_studio_light = false);

/// Where a file without a camera is seen from, why, and how to look from elsewhere; one more line
/// if nearly all of the picture is empty, because objects lie too far apart.
std::vector<std::string> notes_on_standpoint(const Scene& scene, const RayScene& rays,
                                             const Standpoint& standpoint,
                                             const FieldOfView& field_of_view);

}  // namespace foveola
