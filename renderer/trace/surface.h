// From a hit to what light does there: position, normals and the material's values.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/bsdf.h"
#include "renderer/trace/ray_scene.h"

namespace foveola {

/// A point that a ray met, seen from where the ray came from.
///
/// Surfaces scatter on both sides, also where the material is single-sided: many exporters leave
/// glTF's doubleSided off on walls that are seen from behind, and culling them would let light
/// leak. Emission does heed it: single-sided emitters shine from their front face only.
struct SurfacePoint {
  Vec3 position;
  float rounding_error;   ///< metres; see Triangle
  Vec3 geometric_normal;  ///< unit, on the side the ray came from
  Vec3 origin;            ///< where rays leave the surface on the side the ray came from
  Vec3 shading_normal;    ///< unit, on the same side; the ray always comes from its front
  Reflectance reflectance;

  /// Where they leave it on the other side.
  Vec3 origin_beyond() const { return position - rounding_error * geometric_normal; }
};

/// The hit must not be a miss. direction: the ray's, unit length. ray_width_m: how wide the ray is
/// at the hit, across itself; textures are averaged over it. 0 reads them at their finest.
SurfacePoint surface_point(const Scene& scene, const Hit& hit, const Vec3& direction,
                           float ray_width_m = 0.0F);

/// What the surface emits against the ray that hit it.
struct SurfaceEmission {
  Rgb radiance{0.0F};
  float cosine = 0.0F;  ///< of the angle between the ray and the surface's normal, in [0, 1]
};
SurfaceEmission surface_emission(const Scene& scene, const Hit& hit, const Vec3& direction);

/// What `mesh` emits at a point of one of its triangles, towards a side that it shines to.
Rgb emitted_radiance(const Scene& scene, const Mesh& mesh, std::uint32_t triangle,
                     const Vec2& barycentric);

/// The colour of an unlit surface at a hit, which it shows whatever shines on it.
Rgb unlit_color(const Scene& scene, const Hit& hit);

/// The absorption of a solid per metre (KHR_materials_volume): what is left of light after d metres
/// is exp(-d * absorption). Zero for everything else.
Rgb absorption_per_m(const Material& material);

}  // namespace foveola
