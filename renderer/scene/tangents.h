// Tangents, along which normal textures are laid.
#pragma once

#include <cstddef>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// Gives `mesh` tangents along its texture's horizontal axis, perpendicular to its normals, with
/// the sign that makes sign * cross(normal, tangent) the texture's upward axis, against v
/// (glTF 2.0.1, section 3.7.2.1).
///
/// What is done is what MikkTSpace does (Mikkelsen 2008, "Simulation of Wrinkled Surfaces
/// Revisited", appendix A), but for one thing: vertices of equal position, normal and texture
/// coordinates are one; at each the directions of the triangles around it, laid into the plane of
/// its normal, are averaged by the angles of their corners; and triangles whose texture is mirrored
/// are kept apart from those whose is not, for which vertices that both share are doubled.
/// MikkTSpace also keeps apart triangles that meet in a corner without a chain of edges between
/// them.
///
/// Triangles whose texture coordinates span no area have no say; a vertex with no others gets any
/// direction in the plane of its normal. A mesh without normals is flat: its vertices are first
/// unshared, and its tangents lie in its triangles. No tangent is zero or not finite.
///
/// uv_set: an index into mesh.uv_sets. texture_from_mesh: as in TextureUse. Every triangle must
/// have an area.
void add_tangents(Mesh& mesh, int uv_set, const Mat3x2& texture_from_mesh);

/// Makes the tangents of `mesh`, which has normals, perpendicular to them and of unit length, and
/// their signs 1 or -1. Returns how many it could not, because they have no direction that differs
/// from the normal's, or no sign; these it leaves alone.
std::size_t straighten_tangents(Mesh& mesh);

}  // namespace foveola
