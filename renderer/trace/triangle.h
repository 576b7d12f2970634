// The geometry of one triangle of an object in the world: corners, normal, area, and how exact
// they are.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// A bound, in metres, on how far a point computed on a triangle and moved off it may be from where
/// it should be, and a ray that starts near the triangle from meeting it where it should (after
/// Pharr et al., Physically Based Rendering, 4th ed., section 6.8). Coordinates are rounded once
/// for the point and once for the move: half a unit in the last place each, along three axes. What
/// the triangle's sides and the intersection test add is relative to the triangle's size, for both
/// work with differences. An instance's transform adds a few roundings of its terms.
///
/// largest_term: the largest magnitude among the terms whose sums the corners' coordinates are.
/// roundings: how many of such terms' a point may be off. Numbers and vectors, or lanes of them.
template <typename Number, typename Vector>
Number rounding_error_of(const Number& largest_term, const Number& roundings, const Vector& side1,
                         const Vector& side2) {
  const Number sides = max_component(magnitude(side1) + magnitude(side2));
  return std::numeric_limits<float>::epsilon() * (roundings * largest_term + 8.0F * sides);
}

/// For a triangle so small or large that the square of its sides' product leaves a float's range.
/// Unit length; not a number without area.
inline Vec3 front_normal_in_double(const DVec3& p0, const DVec3& p1, const DVec3& p2,
                                   float winding) {
  return Vec3(double{winding} * glm::normalize(glm::cross(p1 - p0, p2 - p0)));
}

struct Triangle {
  /// Between them, the square of twice the area is no trouble.
  static constexpr float smallest_square = 1e-30F;
  static constexpr float largest_square = 1e30F;

  /// Of a mesh that stands in the world as it is, and of instances of one.
  static constexpr float usual_roundings = 2.5F;
  static constexpr float instances_roundings = 10.0F;

  Vec3 p0;
  Vec3 p1;
  Vec3 p2;
  float largest_term;  ///< see rounding_error_of()
  float roundings = usual_roundings;
  float winding = 1.0F;  ///< -1 where a mirroring instance has turned the corners' order around

  /// Of a mesh that stands in the world as it is.
  Triangle(const Mesh& mesh, std::uint32_t index)
      : p0(mesh.positions[mesh.triangles[index][0]]),
        p1(mesh.positions[mesh.triangles[index][1]]),
        p2(mesh.positions[mesh.triangles[index][2]]),
        largest_term(max_component(glm::max(glm::abs(p0), glm::max(glm::abs(p1), glm::abs(p2))))) {}

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
  Vec3 front_normal() const {
    const Vec3 normal = glm::cross(p1 - p0, p2 - p0);
    const float squared_length = glm::dot(normal, normal);
    if (squared_length > smallest_square && squared_length < largest_square) {
      return normal * (winding / std::sqrt(squared_length));
    }
    return front_normal_in_double(p0, p1, p2, winding);
  }

  double area() const {
    return 0.5 * glm::length(glm::cross(DVec3(p1) - DVec3(p0), DVec3(p2) - DVec3(p0)));
  }

  Vec3 at(const Vec2& barycentric) const {
    return p0 + (barycentric.x * (p1 - p0) + barycentric.y * (p2 - p0));
  }

  float rounding_error() const {
    return rounding_error_of(largest_term, roundings, p1 - p0, p2 - p0);
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
