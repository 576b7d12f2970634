// From hits to the geometry of surface points, for one hit or for eight.
#pragma once

#include <limits>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/trace/triangle.h"

namespace foveola {

/// A point off the surface by its rounding error, back along the ray: where the ray came through
/// there is no other surface in between, and so no light leaks in where walls meet. At grazing
/// angles that way is long, but so is the stretch of the ray on which the hit may be; half of the
/// ray is not exceeded, the rest goes along the normal. normal: on the side that the ray came from.
/// distance: that it came. Numbers and vectors, or lanes of them.
template <typename Number, typename Vector>
inline Vector origin_before(const Vector& position, const Vector& direction, const Vector& normal,
                            const Number& distance, const Number& rounding_error) {
  constexpr float no_zero = std::numeric_limits<float>::min();
  const Number cosine = larger(-dot(normal, direction), no_zero);
  const Number back = smaller(rounding_error / cosine, 0.5F * distance);
  const Number rest = larger(rounding_error - back * cosine, 0.0F);
  return position - (back * direction - rest * normal);
}

/// `normal` at unit length, or `otherwise` if it has no direction. Vectors, or lanes of them.
template <typename Vector>
inline Vector normalized_or(const Vector& normal, const Vector& otherwise) {
  const auto squared_length = dot(normal, normal);
  return chosen(squared_length > 0.0F, normal / square_root(squared_length), otherwise);
}

/// How an instance turns normals: the transposed inverse, up to a positive factor.
Mat3 world_normal_from_local(const Mat4& world_from_local);

/// What a surface looks like where a ray met it, from where the ray came from. Number: float, or
/// Floats.
template <typename Number>
struct SurfaceGeometryOf {
  using Vector = Vec3Of<Number>;

  /// Normals that differ by less, 0.08 degrees, are those of a flat surface.
  static constexpr float flattest_cosine = 0.999999F;

  Vector position;
  Number rounding_error;    ///< metres; see TriangleOf
  Number facing;            ///< the cosine between the ray and the front's normal
  Vector geometric_normal;  ///< unit, on the side the ray came from
  Vector origin;            ///< where rays leave the surface on the side the ray came from
  Vector smooth_normal;     ///< unit; the front's, interpolated between the vertices
  Vector shading_normal;    ///< unit, on the same side; the ray always comes from its front
  Vector horizon_normal;  ///< unit: light is reflected above it; the smooth surface's, unless flat

  /// front_normal: the triangle's, unit length. vertex_normal: interpolated between the front's
  /// normals at the corners, of any length; zero where the mesh has none. direction: the ray's,
  /// unit length. distance: that it came.
  SurfaceGeometryOf(const TriangleOf<Number>& triangle, const Vector& front_normal,
                    const Vector& vertex_normal, const Vec2Of<Number>& barycentric,
                    const Vector& direction, const Number& distance)
      : position(triangle.at(barycentric)),
        rounding_error(triangle.rounding_error()),
        facing(-dot(front_normal, direction)),
        geometric_normal(chosen(facing < 0.0F, -front_normal, front_normal)),
        origin(origin_before(position, direction, geometric_normal, distance, rounding_error)),
        smooth_normal(normalized_or(vertex_normal, front_normal)),
        shading_normal(turned_to_ray(smooth_normal, geometric_normal, smooth_normal, direction,
                                     geometric_normal)),
        horizon_normal(chosen(dot(shading_normal, geometric_normal) > flattest_cosine,
                              geometric_normal, shading_normal)) {}

  /// The shading normal if a normal map makes `mapped` of the smooth normal.
  Vector mapped_shading_normal(const Vector& mapped, const Vector& direction) const {
    return turned_to_ray(smooth_normal, geometric_normal, mapped, direction, shading_normal);
  }

  /// `normal` of the front turned to the side of the geometric normal, or `otherwise` if that is
  /// turned away from the ray.
  static Vector turned_to_ray(const Vector& smooth, const Vector& geometric, const Vector& normal,
                              const Vector& direction, const Vector& otherwise) {
    const Vector turned = with_sign(1.0F, dot(smooth, geometric)) * normal;
    return chosen(dot(turned, direction) < 0.0F, turned, otherwise);
  }
};

}  // namespace foveola
