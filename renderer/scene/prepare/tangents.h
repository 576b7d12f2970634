// Computes tangents for normal textures.
#pragma once

#include <cstddef>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// Gives `mesh` tangents along its texture's horizontal axis, perpendicular to its normals, with
/// the sign that makes sign * cross(normal, tangent) the texture's upward axis, against v (glTF
/// 2.0.1, section 3.7.2.1).
///
/// Follows MikkTSpace (Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited", appendix A).
/// Vertices of equal position, normal and texture coordinates are merged. At each, the surrounding
/// triangles' directions, projected into the plane of its normal, are averaged by the angles of
/// their corners. Vertices shared by triangles with mirrored and unmirrored textures are split.
/// Unlike here, MikkTSpace also separates triangles that meet in a corner without a chain of edges
/// between them.
///
/// Triangles whose texture coordinates span no area are ignored; a vertex with no others gets any
/// direction in the plane of its normal. A mesh without normals is flat: its vertices are first
/// unshared, and its tangents lie in its triangles. No tangent is zero or not finite.
///
/// uv_set: an index into mesh.uv_sets. texture_from_mesh: as in TextureUse. Every triangle must
/// have an area.
void add_tangents(Mesh& mesh, int uv_set, const Mat3x2& texture_from_mesh);

/// Makes the tangents of `mesh`, which has normals, perpendicular to them and of unit length, with
/// signs 1 or -1. Returns the number of tangents left unchanged, because they are parallel to the
/// normal or have no sign.
std::size_t straighten_tangents(Mesh& mesh);

}  // namespace foveola
