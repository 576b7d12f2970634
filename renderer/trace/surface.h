// From a hit to what light does there: position, normals and the material's values.
#pragma once

#include <limits>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/bsdf_value.h"
#include "renderer/trace/mesh_attributes.h"
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

// What surface_point() puts together, for those who do so for several points at once.

/// How an instance turns normals: the transposed inverse, up to a positive factor.
Mat3 world_normal_from_local(const Mat4& world_from_local);

/// What the normal texture makes of the front's `normal`, interpolated between the vertices; that
/// itself where the mesh has no tangents.
Vec3 mapped_normal(const Scene& scene, const MeshPoint& point, const Instance* instance,
                   const Vec3& normal);

Reflectance untextured_reflectance(const Material& material);
Reflectance reflectance_at(const Scene& scene, const MeshPoint& point, bool is_back);

/// MeshPoint::relative_width. facing: the cosine between the ray and the surface's normal.
/// double_area: of the triangle, in square metres.
float relative_width(float ray_width_m, float facing, float double_area);

/// A point off the surface by its rounding error, back along the ray: where the ray came through
/// there is no other surface in between, and so no light leaks in where walls meet. At grazing
/// angles that way is long, but so is the stretch of the ray on which the hit may be; half of the
/// ray is not exceeded, the rest goes along the normal. normal: on the side that the ray came from.
/// distance: that it came. Numbers and vectors, or lanes of them.
template <typename Number, typename Vector>
Vector origin_before(const Vector& position, const Vector& direction, const Vector& normal,
                     const Number& distance, const Number& rounding_error) {
  constexpr float no_zero = std::numeric_limits<float>::min();
  const Number cosine = larger(-dot(normal, direction), no_zero);
  const Number back = smaller(rounding_error / cosine, 0.5F * distance);
  const Number rest = larger(rounding_error - back * cosine, 0.0F);
  return position - (back * direction - rest * normal);
}

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
