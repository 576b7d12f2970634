// Alpha: how much of a surface is there, and what lets light pass without bending it.
#pragma once

#include <cstdint>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// The probability, in [0, 1], with which a ray meets a point of the mesh: its alpha where the
/// material blends, 0 or 1 on the two sides of a mask's cutoff, 1 for an opaque material.
float opacity(const Scene& scene, const Mesh& mesh, std::uint32_t triangle,
              const Vec2& barycentric);

/// Whether opacity() is not 1 everywhere on the mesh, so that each hit must be asked.
bool has_opacity(const Scene& scene, const Mesh& mesh);

/// Whether opacity() is 0 everywhere, or the mesh has no triangles.
bool is_invisible(const Scene& scene, const Mesh& mesh);

/// Whether the material is a smooth thin wall that lets light through straight: shadow rays pass
/// it, and are tinted.
bool is_thin_transmissive(const Material& material);

}  // namespace foveola
