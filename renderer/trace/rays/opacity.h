// Opacity of surfaces, and thin surfaces that transmit light without refraction.
#pragma once

#include <cstdint>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// Probability, in [0, 1], that a ray hits a point of the mesh: its alpha if the material blends, 0
/// or 1 on the two sides of a mask's cutoff, 1 for an opaque material.
float opacity(const Scene& scene, const Mesh& mesh, std::uint32_t triangle,
              const Vec2& barycentric);

/// Whether opacity() is below 1 anywhere on the mesh, so that each hit must be tested.
bool has_opacity(const Scene& scene, const Mesh& mesh);

/// Whether opacity() is 0 everywhere, or the mesh has no triangles.
bool is_invisible(const Scene& scene, const Mesh& mesh);

/// Whether the material is a smooth thin wall that transmits light straight: shadow rays pass it,
/// tinted.
bool is_thin_transmissive(const Material& material);

}  // namespace foveola
