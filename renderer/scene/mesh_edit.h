// What loaders do to meshes: move them, and take out or mend what cannot be rendered.
#pragma once

#include <cstddef>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// Calls `edit` with each list of `mesh` that has one element a vertex.
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

/// Moves `mesh`, in double precision. A transform that mirrors swaps two corners of each triangle,
/// so that front faces stay in front (glTF 2.0.1, section 3.7.4). Normals and tangents come out of
/// unit length, or not finite where the transform leaves none.
void transform(Mesh& mesh, const DMat4& to_from);

/// Drops triangles that have no area or are not finite, then the vertices that only they used.
/// Returns how many.
std::size_t drop_degenerate_triangles(Mesh& mesh);

/// Gives normals unit length, and those that have no direction that of the triangles around them.
/// Returns how many had none.
std::size_t repair_normals(Mesh& mesh);

/// Replaces texture coordinates that are not finite by 0. Returns how many.
std::size_t repair_uvs(Mesh& mesh);

/// Brings vertex colours into [0, 1]; those that are not a number become 1. Returns how many
/// vertices changed.
std::size_t repair_colors(Mesh& mesh);

/// Takes the vertex colours away if all are white and change nothing.
void drop_white_colors(Mesh& mesh);

}  // namespace foveola
