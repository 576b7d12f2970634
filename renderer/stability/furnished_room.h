// A closed room with a lamp and some objects, for scaling, moving, and writing and loading as glTF.
#pragma once

#include <string>

#include "renderer/scene/scene.h"

namespace foveola {

/// The distance between opposite walls, in metres: the room's size.
constexpr float room_size_m = 2.0F;

/// A room of coloured diffuse walls around the origin, with a lamp below its ceiling, a tilted box,
/// a diffuse ball and a glossy metal ring, both smoothly shaded. All objects are in `meshes`.
Scene furnished_room();

/// The same room with every special case of paths: glass, smooth, rough and tinted, with a lamp in
/// it; a thin transmissive pane and a sky behind it; a blended sheet; coats, sheen, a mirror;
/// textures and a normal map; instances, one of them mirrored; a sun and point lights.
Scene room_of_everything();

/// A viewpoint in the middle of the room with a view of all of it.
constexpr Vec3 room_viewpoint{0.1F, 0.15F, 0.2F};

/// Scales and then moves every vertex, in floats, and then rebases the scene as the loaders do. The
/// scene must have meshes only.
Scene baked(Scene scene, float scale, const Vec3& place);

/// The bytes of a .glb file in which a node moves all of `scene` by `translation_m`. Positions are
/// written unchanged, even non-finite ones; meshes and the factors of materials are written,
/// textures, instances and lights are not. The only camera is at `viewpoint`, moved by the same
/// translation.
std::string glb_of(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m);

/// The result of load_gltf for that file, written to a temporary folder. Throws Error if it cannot
/// be written or loaded.
Scene through_gltf(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m);

}  // namespace foveola
