// The geometry of one triangle of an object in the world: corners, normal, area, and how exact
// they are.
#pragma once

#include <cstdint>
#include <limits>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// For a triangle so small or large that the square of its sides' product leaves a float's range.
/// Unit length; not a number without area.
inline Vec3 front_normal_in_double(const DVec3& p0, const DVec3& p1, const DVec3& p2,
                                   float winding) {
  return Vec3(double{winding} * glm::normalize(glm::cross(p1 - p0, p2 - p0)));
}

/// A triangle in the world, or eight of them. Number: float, or Floats.
template <typename Number>
struct TriangleOf {
  using Vector = Vec3Of<Number>;

  /// Between them, the square of twice the area needs no double.
  static constexpr float smallest_square = 1e-30F;
  static constexpr float largest_square = 1e30F;

  /// Of a mesh that stands in the world as it is, and of instances of one.
  static constexpr float usual_roundings = 2.5F;
  static constexpr float instances_roundings = 10.0F;

  Vector p0, p1, p2;
  Number largest_term;  ///< see rounding_error()
  Number roundings;
  Number winding;  ///< -1 where a mirroring instance has turned the corners' order around, else 1

  Vector at(const Vec2Of<Number>& barycentric) const {
    return p0 + (barycentric.x * (p1 - p0) + barycentric.y * (p2 - p0));
  }

  struct Front {
    Vector normal;            ///< unit length
    Number double_area;       ///< square metres
    MaskOf<Number> is_exact;  ///< else the normal is front_normal_in_double()'s
  };
  Front front() const {
    const Vector across = cross(p1 - p0, p2 - p0);
    const Number squared = dot(across, across);
    const Number double_area = square_root(squared);
    return {.normal = (winding / double_area) * across,
            .double_area = double_area,
            .is_exact = MaskOf<Number>((squared > smallest_square) & (squared < largest_square))};
  }

  /// A bound, in metres, on how far a point computed on a triangle and moved off it may be from
  /// where it should be, and a ray that starts near the triangle from meeting it where it should
  /// (after Pharr et al., Physically Based Rendering, 4th ed., section 6.8). Coordinates are
  /// rounded once for the point and once for the move: half a unit in the last place each, along
  /// three axes. What the triangle's sides and the intersection test add is relative to the
  /// triangle's size, for both work with differences. An instance's transform adds a few roundings
  /// of its terms.
  ///
  /// largest_term is the largest magnitude among the terms whose sums the corners' coordinates are;
  /// a point may be off by as many roundings of such terms as `roundings` says.
  Number rounding_error() const {
    const Number sides = max_component(magnitude(p1 - p0) + magnitude(p2 - p0));
    return std::numeric_limits<float>::epsilon() * (roundings * largest_term + 8.0F * sides);
  }
};

/// The largest magnitude among three vectors' coordinates. Vectors, or lanes of them.
template <typename Vector>
inline auto largest_coordinate(const Vector& p0, const Vector& p1, const Vector& p2) {
  return max_component(larger(magnitude(p0), larger(magnitude(p1), magnitude(p2))));
}

struct Triangle : TriangleOf<float> {
  /// Of a mesh that stands in the world as it is.
  Triangle(const Mesh& mesh, std::uint32_t index)
      : TriangleOf{.p0 = mesh.positions[mesh.triangles[index][0]],
                   .p1 = mesh.positions[mesh.triangles[index][1]],
                   .p2 = mesh.positions[mesh.triangles[index][2]],
                   .largest_term = 0.0F,
                   .roundings = usual_roundings,
                   .winding = 1.0F} {
    largest_term = largest_coordinate(p0, p1, p2);
  }

  /// Of an instance of a mesh, or of a mesh that stands in the world if there is none.
  Triangle(const Mesh& mesh, const Instance* instance, std::uint32_t index)
      : Triangle(mesh, index) {
    if (instance != nullptr) {
      place(instance->world_from_local);
    }
  }

  /// Of an object of the scene.
  Triangle(const Scene& scene, std::uint32_t object, std::uint32_t index)
      : Triangle(scene.mesh_of(object), scene.instance_of(object), index) {}

  /// The front face's normal, unit length; not a number without area.
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

}  // namespace foveola
