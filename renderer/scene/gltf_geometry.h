// Triangles out of glTF primitives, and their baking into world space.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace foveola {

/// The triangles of `primitive` in its own space, with the vertices that they use and no others;
/// material and name are left alone. uv_set: which TEXCOORD to read; none for an untextured
/// material. Empty, with a warning, for points and lines. Throws GltfFault, with places below
/// `place`, the primitive's JSON path.
std::optional<Mesh> read_primitive(const tinygltf::Model& model,
                                   const tinygltf::Primitive& primitive, std::optional<int> uv_set,
                                   const std::string& place, Warnings& warnings);

/// Moves `mesh` to the world. A transform that mirrors swaps two corners of each triangle, so that
/// front faces stay in front (specification, section 3.7.4). Drops triangles that have no area or
/// are not finite there, and the vertices that only they used; gives normals that are not usable
/// the direction of the triangles around them.
void bake(Mesh& mesh, const DMat4& world_from_local, const std::string& place, Warnings& warnings);

}  // namespace foveola
