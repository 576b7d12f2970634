// Geometry of a triangle in the world (corners, normal, area, rounding error), and of points that
// rays hit on it.
#pragma once

#include <cstdint>
#include <limits>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// For extreme triangles, the square of whose sides' product leaves a float's range. Unit length;
/// NaN without area.
inline Vec3 front_normal_in_double(const DVec3& p0, const DVec3& p1, const DVec3& p2,
                                   float winding) {
  return Vec3(double{winding} * glm::normalize(glm::cross(p1 - p0, p2 - p0)));
}

/// A triangle in the world, or eight of them. Number: float, or Floats.
template <typename Number>
struct TriangleOf {
  using Vector = Vec3Of<Number>;

  /// Between these, the square of twice the area needs no double.
  static constexpr float smallest_square = 1e-30F;
  static constexpr float largest_square = 1e30F;

  /// Of meshes that are not instanced, and of instances.
  static constexpr float default_roundings = 2.5F;
  static constexpr float instances_roundings = 10.0F;

  Vector p0, p1, p2;
  Number largest_term;  ///< see rounding_error()
  Number roundings;
  Number winding;  ///< -1 if a mirroring instance reverses the corners' order, else 1

  Vector at(const Vec2Of<Number>& barycentric) const {
    return p0 + (barycentric.x * (p1 - p0) + barycentric.y * (p2 - p0));
  }

  struct Front {
    Vector normal;            ///< unit length
    Number double_area;       ///< square metres
    MaskOf<Number> is_exact;  ///< otherwise the normal is front_normal_in_double()'s
  };
  Front front() const {
    const Vector across = cross(p1 - p0, p2 - p0);
    const Number squared = dot(across, across);
    const Number double_area = square_root(squared);
    return {.normal = (winding / double_area) * across,
            .double_area = double_area,
            .is_exact = MaskOf<Number>((squared > smallest_square) & (squared < largest_square))};
  }

  /// A bound, in metres, on the rounding error of a point computed on a triangle and moved off it,
  /// and of the hit of a ray from near the triangle (after Pharr et al., Physically Based
  /// Rendering, 4th ed., section 6.8). Coordinates are rounded once for the point and once for the
  /// move: half a unit in the last place each, along three axes. The sides and the intersection
  /// test work with differences: their errors are relative to the triangle's size. An instance's
  /// transform adds a few roundings of its terms.
  ///
  /// largest_term: the largest magnitude among the terms of the corners' coordinates. roundings:
  /// number of roundings of such terms.
  Number rounding_error() const {
    const Number sides = max_component(magnitude(p1 - p0) + magnitude(p2 - p0));
    return std::numeric_limits<float>::epsilon() * (roundings * largest_term + 8.0F * sides);
  }
};

/// The largest magnitude among three vectors' coordinates. Vectors, or lanes of vectors.
template <typename Vector>
inline auto largest_coordinate(const Vector& p0, const Vector& p1, const Vector& p2) {
  return max_component(larger(magnitude(p0), larger(magnitude(p1), magnitude(p2))));
}

struct Triangle : TriangleOf<float> {
  /// Of a mesh that is not instanced.
  Triangle(const Mesh& mesh, std::uint32_t index)
      : TriangleOf{.p0 = mesh.positions[mesh.triangles[index][0]],
                   .p1 = mesh.positions[mesh.triangles[index][1]],
                   .p2 = mesh.positions[mesh.triangles[index][2]],
                   .largest_term = 0.0F,
                   .roundings = default_roundings,
                   .winding = 1.0F} {
    largest_term = largest_coordinate(p0, p1, p2);
  }

  /// Of an instance of a mesh, or of the mesh itself if `instance` is null.
  Triangle(const Mesh& mesh, const Instance* instance, std::uint32_t index)
      : Triangle(mesh, index) {
    if (instance != nullptr) {
      place(instance->world_from_local);
    }
  }

  /// Of an object of the scene.
  Triangle(const Scene& scene, std::uint32_t object, std::uint32_t index)
      : Triangle(scene.mesh_of(object), scene.instance_of(object), index) {}

  /// The front face's normal, unit length; NaN without area.
  Vec3 front_normal() const { return normal_of(front()); }
  Vec3 normal_of(const Front& front) const {
    return front.is_exact ? front.normal : front_normal_in_double(p0, p1, p2, winding);
  }

  double area() const {
    return 0.5 * glm::length(glm::cross(DVec3(p1) - DVec3(p0), DVec3(p2) - DVec3(p0)));
  }

 private:
  void place(const Mat4& world_from_local) {
    const Vec3 local(glm::max(glm::abs(p0), glm::max(glm::abs(p1), glm::abs(p2))));
    const Mat3 linear(world_from_local);
    const Vec3 translation(world_from_local[3]);
    const Mat3 magnitude(glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2]));
    roundings = instances_roundings;
    largest_term = max_component(magnitude * local + glm::abs(translation));
    p0 = linear * p0 + translation;
    p1 = linear * p1 + translation;
    p2 = linear * p2 + translation;
    winding = glm::determinant(linear) < 0.0F ? -1.0F : 1.0F;
  }
};

/// A point off the surface by its rounding error, back along the ray. No other surface lies
/// between, so that light does not leak where walls meet. At grazing angles that way is long, like
/// the hit's uncertainty along the ray: it is limited to half the ray, and the rest follows the
/// normal. normal: on the ray's side. distance: of the hit. Numbers and vectors, or lanes of them.
template <typename Number, typename Vector>
inline Vector origin_before(const Vector& position, const Vector& direction, const Vector& normal,
                            const Number& distance, const Number& rounding_error) {
  constexpr float no_zero = std::numeric_limits<float>::min();
  const Number cosine = larger(-dot(normal, direction), no_zero);
  const Number back = smaller(rounding_error / cosine, 0.5F * distance);
  const Number rest = larger(rounding_error - back * cosine, 0.0F);
  return position - (back * direction - rest * normal);
}

/// `normal` at unit length, or `otherwise` if its length is 0 or NaN. Vectors, or lanes of them.
template <typename Vector>
inline Vector normalized_or(const Vector& normal, const Vector& otherwise) {
  const auto squared_length = dot(normal, normal);
  return chosen(squared_length > 0.0F, normal / square_root(squared_length), otherwise);
}

/// The matrix of an instance's normals: the transposed inverse, up to a positive factor.
Mat3 world_normal_from_local(const Mat4& world_from_local);

/// Surface geometry at a hit, seen from the ray's origin. Number: float, or Floats.
template <typename Number>
struct SurfaceGeometryOf {
  using Vector = Vec3Of<Number>;

  /// Normals that differ by less than 0.08 degrees belong to a flat surface.
  static constexpr float flattest_cosine = 0.999999F;

  Vector position;
  Number rounding_error;    ///< metres; see TriangleOf
  Number facing;            ///< the cosine between the ray and the front's normal
  Vector geometric_normal;  ///< unit, on the ray's side
  Vector origin;            ///< origin of rays that leave on the ray's side
  Vector smooth_normal;     ///< unit; interpolated between the front's vertex normals
  Vector shading_normal;    ///< unit, on the ray's side; always facing the ray
  Vector horizon_normal;    ///< unit: light is reflected above it; the smooth normal, unless flat

  /// front_normal: of the triangle, unit length. vertex_normal: interpolated between the front's
  /// vertex normals, of any length; zero if the mesh has none. direction: of the ray, unit length.
  /// distance: of the hit.
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

  /// The shading normal after a normal map gave `mapped` for the smooth normal.
  Vector mapped_shading_normal(const Vector& mapped, const Vector& direction) const {
    return turned_to_ray(smooth_normal, geometric_normal, mapped, direction, shading_normal);
  }

  /// The front's `normal`, turned to the side of the geometric normal; `otherwise` if that faces
  /// away from the ray.
  static Vector turned_to_ray(const Vector& smooth, const Vector& geometric, const Vector& normal,
                              const Vector& direction, const Vector& otherwise) {
    const Vector turned = with_sign(1.0F, dot(smooth, geometric)) * normal;
    return chosen(dot(turned, direction) < 0.0F, turned, otherwise);
  }
};

}  // namespace foveola
