// Sends a scene made in code through a glTF file and the loader, the way that all other scenes come
// in.
#pragma once

#include <string>

#include "renderer/scene/scene.h"

namespace foveola {

/// The bytes of a .glb file in which a node moves all of `scene` by `translation_m`. Positions are
/// written as they are, also those that are not finite; meshes and the factors of materials are
/// written, textures, instances and lights are not. The only camera stands at `viewpoint`, moved
/// by the same translation.
std::string glb_of(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m);

/// What load_gltf makes of that file, which lives in a temporary folder for the time of the call.
/// Throws Error where it cannot be written or loaded.
Scene through_gltf(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m);

}  // namespace foveola
