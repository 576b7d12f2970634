// A closed room with a lamp and some objects, to be scaled, moved, and sent through a glTF file and
// its loader.
#pragma once

#include <string>

#include "renderer/scene/scene.h"

namespace foveola {

/// The distance between opposite walls, in metres: what "its own size" means.
constexpr float room_size_m = 2.0F;

/// A room of coloured diffuse walls around the origin with a lamp below its ceiling, a tilted box,
/// a diffuse ball and a glossy metal ring, both smoothly shaded. Everything lies in `meshes`.
Scene furnished_room();

/// The same room with all that paths treat in ways of their own: glass, smooth, rough and tinted,
/// with a lamp in it; a thin transmissive pane and a sky behind it; a blended sheet; coats, sheen,
/// a mirror; textures and a normal map; instances, one of them mirrored; a sun and points of light.
Scene room_of_everything();

/// A viewpoint in the middle of the room that sees all of it.
constexpr Vec3 room_viewpoint{0.1F, 0.15F, 0.2F};

/// Every vertex scaled and then moved, in floats, and the whole then given an origin of its own, as
/// the loaders do. The scene must have meshes only.
Scene baked(Scene scene, float scale, const Vec3& place);

/// The bytes of a .glb file in which a node moves all of `scene` by `translation_m`. Positions are
/// written as they are, also those that are not finite; meshes and the factors of materials are
/// written, textures, instances and lights are not. The only camera stands at `viewpoint`, moved
/// by the same translation.
std::string glb_of(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m);

/// What load_gltf makes of that file, which lives in a temporary folder for the time of the call.
/// Throws Error where it cannot be written or loaded.
Scene through_gltf(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m);

}  // namespace foveola
