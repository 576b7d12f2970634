// From a hit to what light does there: position, normals and the material's values.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/rays/mesh_attributes.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/trace/surfaces/triangle.h"

namespace foveola {

/// A point that a ray met, seen from where the ray came from.
///
/// Surfaces scatter on both sides, also where the material is single-sided: many exporters leave
/// glTF's doubleSided off on walls that are seen from behind, and culling them would let light
/// leak. Emission does heed it: single-sided emitters shine from their front face only.
struct SurfacePoint : SurfaceGeometryOf<float> {
  Reflectance reflectance;
  Vec3 coat_normal;  ///< unit; the clear coat's, on the side that the ray came from

  /// Where rays leave the surface on the other side.
  Vec3 origin_beyond() const { return position - rounding_error * geometric_normal; }
};

/// The hit must not be a miss. direction: the ray's, unit length. ray_width_m: how wide the ray is
/// at the hit, across itself; textures are averaged over it. 0 reads them at their finest.
SurfacePoint surface_point(const Scene& scene, const Hit& hit, const Vec3& direction,
                           float ray_width_m = 0.0F);

// What surface_point() puts together, for those who do so for several points at once.

/// A texture of normals as a material uses it.
struct NormalMap {
  const TextureUse& texture;
  float scale;
};
inline NormalMap normal_map(const Material& material) {
  return {material.normal_texture, material.normal_scale};
}

/// What the map makes of the front's `normal`, interpolated between the vertices; that itself where
/// there is no map or the mesh has no tangents.
Vec3 mapped_normal(const Scene& scene, const NormalMap& map, const MeshPoint& point,
                   const Instance* instance, const Vec3& normal);

Reflectance untextured_reflectance(const Material& material);
Reflectance reflectance_at(const Scene& scene, const MeshPoint& point, bool is_back);

/// The way from a point of a triangle to the smooth surface that its vertices' normals describe, as
/// far as that bulges towards `side`, a normal of the triangle (Hanika 2021, "Hacking the Shadow
/// Terminator"). 0 where it does not.
Vec3 smooth_bulge(const Scene& scene, const Hit& hit, const Vec3& side);

/// MeshPoint::relative_width. facing: the cosine between the ray and the surface's normal.
/// double_area: of the triangle, in square metres.
float relative_width(float ray_width_m, float facing, float double_area);

/// What the surface emits against the ray that hit it.
struct SurfaceEmission {
  Rgb radiance{0.0F};
  float cosine = 0.0F;  ///< between the ray and the surface's normal, in [0, 1]
};
SurfaceEmission surface_emission(const Scene& scene, const Hit& hit, const Vec3& direction);

/// What an object emits at a point of one of its triangles against `direction` (unit length), on a
/// side that it shines to. A clear coat reflects its share back (KHR_materials_clearcoat).
Rgb emitted_radiance(const Scene& scene, std::uint32_t object, std::uint32_t triangle,
                     const Vec2& barycentric, const Vec3& direction);

/// The colour of an unlit surface at a hit, which it shows whatever shines on it.
Rgb unlit_color(const Scene& scene, const Hit& hit);

/// The absorption of a solid per metre (KHR_materials_volume): what is left of light after d metres
/// is exp(-d * absorption). Zero for everything else.
Rgb absorption_per_m(const Material& material);

}  // namespace foveola
