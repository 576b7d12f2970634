// Edits meshes for loaders: transforms, and repair or removal of unusable geometry.
#pragma once

#include <cstddef>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// Calls `edit` with each list of `mesh` that has one element per vertex.
template <typename Edit>
void for_each_vertex_list(Mesh& mesh, Edit edit) {
  edit(mesh.positions);
  if (!mesh.normals.empty()) {
    edit(mesh.normals);
  }
  if (!mesh.tangents.empty()) {
    edit(mesh.tangents);
  }
  if (!mesh.colors.empty()) {
    edit(mesh.colors);
  }
  for (auto& uvs : mesh.uv_sets) {
    edit(uvs);
  }
}

/// Transforms `mesh` in double precision. A mirroring transform swaps two corners of each triangle,
/// so that front faces stay in front (glTF 2.0.1, section 3.7.4). Resulting normals and tangents
/// are not of unit length, and may be non-finite.
void transform(Mesh& mesh, const DMat4& to_from);

/// Drops triangles without area or with non-finite corners, then their otherwise unused vertices.
/// Returns the number of dropped triangles.
std::size_t drop_degenerate_triangles(Mesh& mesh);

/// Normalises normals; those without direction get that of the surrounding triangles. Returns the
/// number without direction.
std::size_t repair_normals(Mesh& mesh);

/// Replaces non-finite texture coordinates by 0. Returns their number.
std::size_t repair_uvs(Mesh& mesh);

/// Clamps vertex colours to [0, 1]; NaN becomes 1. Returns the number of changed vertices.
std::size_t repair_colors(Mesh& mesh);

/// Removes the vertex colours if all are white.
void drop_white_colors(Mesh& mesh);

}  // namespace foveola
