// Evaluates a hit's surface: position, normals and material values.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/rays/mesh_attributes.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/trace/surfaces/triangle.h"

namespace foveola {

/// A point that a ray hit, seen from the ray's origin.
///
/// Surfaces scatter on both sides, even single-sided ones: many exporters leave glTF's doubleSided
/// off on walls that are seen from behind, and culling them would leak light. Single-sided emitters
/// emit from their front face only.
struct SurfacePoint : SurfaceGeometryOf<float> {
  Reflectance reflectance;
  Vec3 coat_normal;  ///< unit; of the clear coat, on the ray's side

  /// Origin of rays that leave the surface on the other side.
  Vec3 origin_beyond() const { return position - rounding_error * geometric_normal; }
};

/// The hit must not be a miss. direction: of the ray, unit length. ray_width_m: the ray's width at
/// the hit, over which textures are filtered. 0 reads their finest level.
SurfacePoint surface_point(const Scene& scene, const Hit& hit, const Vec3& direction,
                           float ray_width_m = 0.0F);

// Parts of surface_point(), for callers that process several points at once.

/// A texture of normals as a material uses it.
struct NormalMap {
  const TextureUse& texture;
  float scale;
};
inline NormalMap normal_map(const Material& material) {
  return {material.normal_texture, material.normal_scale};
}

/// Applies the normal map to the front's interpolated `normal`. Returns `normal` without a map or
/// tangents.
Vec3 mapped_normal(const Scene& scene, const NormalMap& map, const MeshPoint& point,
                   const Instance* instance, const Vec3& normal);

Reflectance untextured_reflectance(const Material& material);
Reflectance reflectance_at(const Scene& scene, const MeshPoint& point, bool is_back);

/// Offset from a point of a triangle to the smooth surface that its vertex normals describe, where
/// that bulges towards `side`, a normal of the triangle (Hanika 2021, "Hacking the Shadow
/// Terminator"). 0 elsewhere.
Vec3 smooth_bulge(const Scene& scene, const Hit& hit, const Vec3& side);

/// Computes MeshPoint::relative_width. facing: the cosine between the ray and the surface's normal.
/// double_area: twice the triangle's area, in square metres.
float relative_width(float ray_width_m, float facing, float double_area);

/// Emission of a surface against the ray that hit it.
struct SurfaceEmission {
  Rgb radiance{0.0F};
  float cosine = 0.0F;  ///< between the ray and the surface's normal, in [0, 1]
};
SurfaceEmission surface_emission(const Scene& scene, const Hit& hit, const Vec3& direction);

/// Emitted radiance at a point of an object's triangle against `direction` (unit length), on an
/// emitting side. A clear coat reflects its share back (KHR_materials_clearcoat).
Rgb emitted_radiance(const Scene& scene, std::uint32_t object, std::uint32_t triangle,
                     const Vec2& barycentric, const Vec3& direction);

/// The colour of an unlit surface at a hit, independent of light.
Rgb unlit_color(const Scene& scene, const Hit& hit);

/// Absorption per metre of a solid (KHR_materials_volume): the transmittance of d metres is exp(-d
/// * absorption). Zero for other materials.
Rgb absorption_per_m(const Material& material);

}  // namespace foveola
