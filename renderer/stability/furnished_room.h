// The scene that is scaled, moved, written and read: a closed room with a lamp and some objects.
#pragma once

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

}  // namespace foveola
