// From a hit to what light does there: position, normals and the material's values.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/bsdf.h"
#include "renderer/trace/ray_scene.h"

namespace foveola {

/// A point that a ray met, seen from where the ray came from.
///
/// Surfaces reflect on both sides, also where the material is single-sided: many exporters leave
/// glTF's doubleSided off on walls that are seen from behind, and culling them would let light
/// leak. Emission does heed it: single-sided emitters shine from their front face only.
struct SurfacePoint {
  Vec3 origin;            ///< the point, moved off the surface: where rays leave it
  Vec3 geometric_normal;  ///< unit, on the side the ray came from
  Vec3 shading_normal;    ///< unit, on the same side; the ray always comes from its front
  Reflectance reflectance;
};

/// The hit must not be a miss. direction: the ray's, unit length.
SurfacePoint surface_point(const Scene& scene, const Hit& hit, const Vec3& direction);

/// What the surface emits against the ray that hit it.
struct SurfaceEmission {
  Rgb radiance{0.0F};
  float cosine = 0.0F;  ///< of the angle between the ray and the surface's normal, in [0, 1]
};
SurfaceEmission surface_emission(const Scene& scene, const Hit& hit, const Vec3& direction);

/// What `mesh` emits at a point of one of its triangles, towards a side that it shines to.
Rgb emitted_radiance(const Scene& scene, const Mesh& mesh, std::uint32_t triangle,
                     const Vec2& barycentric);

}  // namespace foveola
