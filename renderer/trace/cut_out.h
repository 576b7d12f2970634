// Alpha cut-outs: which points of a mesh are holes.
#pragma once

#include <cstdint>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// Whether some points of the mesh may be holes and others not, so that each hit must be asked.
bool has_varying_alpha(const Scene& scene, const Mesh& mesh);

/// Whether a point of the mesh is a hole: its alpha is below the material's cutoff.
bool is_hole(const Scene& scene, const Mesh& mesh, std::uint32_t triangle, const Vec2& barycentric);

/// Whether the whole mesh is one hole, or has no triangles.
bool is_invisible(const Scene& scene, const Mesh& mesh);

}  // namespace foveola
