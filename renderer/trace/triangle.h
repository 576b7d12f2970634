// The geometry of one triangle of an object in the world: corners, normal, area, and how exact
// they are.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

struct Triangle {
  Vec3 p0;
  Vec3 p1;
  Vec3 p2;
  /// The largest magnitude among the terms whose sums the corners' coordinates are.
  float largest_term;
  float roundings = 2.5F;  ///< of terms, that a point on the triangle may be off
  float winding = 1.0F;    ///< -1 where a mirroring instance has turned the corners' order around

  /// Of a mesh that stands in the world as it is.
  Triangle(const Mesh& mesh, std::uint32_t index)
      : p0(mesh.positions[mesh.triangles[index][0]]),
        p1(mesh.positions[mesh.triangles[index][1]]),
        p2(mesh.positions[mesh.triangles[index][2]]),
        largest_term(max_component(glm::max(glm::abs(p0), glm::max(glm::abs(p1), glm::abs(p2))))) {}

  /// Of an object of the scene.
  Triangle(const Scene& scene, std::uint32_t object, std::uint32_t index)
      : Triangle(scene.mesh_of(object), index) {
    if (const Instance* instance = scene.instance_of(object); instance != nullptr) {
      place(instance->world_from_local);
    }
  }

  /// The front face's normal, unit length; not a number without area.
  Vec3 front_normal() const {
    const Vec3 normal = glm::cross(p1 - p0, p2 - p0);
    const float squared_length = glm::dot(normal, normal);
    if (squared_length > 1e-30F && squared_length < 1e30F) {
      return normal * (winding / std::sqrt(squared_length));
    }
    // The squares of very small or large sides' products leave the range of a float.
    return Vec3(double{winding} *
                glm::normalize(glm::cross(DVec3(p1) - DVec3(p0), DVec3(p2) - DVec3(p0))));
  }

  double area() const {
    return 0.5 * glm::length(glm::cross(DVec3(p1) - DVec3(p0), DVec3(p2) - DVec3(p0)));
  }

  Vec3 at(const Vec2& barycentric) const {
    return p0 + (barycentric.x * (p1 - p0) + barycentric.y * (p2 - p0));
  }

  /// A bound, in metres, on how far a point computed on the triangle and moved off it may be from
  /// where it should be, and a ray that starts near the triangle from meeting it where it should
  /// (after Pharr et al., Physically Based Rendering, 4th ed., section 6.8). Coordinates are
  /// rounded once for the point and once for the move: half a unit in the last place each, along
  /// three axes. What the triangle's sides and the intersection test add is relative to the
  /// triangle's size, for both work with differences. An instance's transform adds a few roundings
  /// of its terms.
  float rounding_error() const {
    const float sides = max_component(glm::abs(p1 - p0) + glm::abs(p2 - p0));
    return std::numeric_limits<float>::epsilon() * (roundings * largest_term + 8.0F * sides);
  }

 private:
  void place(const Mat4& world_from_local) {
    const Vec3 local(glm::max(glm::abs(p0), glm::max(glm::abs(p1), glm::abs(p2))));
    const Mat3 linear(world_from_local);
    const Vec3 translation(world_from_local[3]);
    const Mat3 magnitude(glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2]));
    roundings = 10.0F;
    largest_term = max_component(magnitude * local + glm::abs(translation));
    p0 = linear * p0 + translation;
    p1 = linear * p1 + translation;
    p2 = linear * p2 + translation;
    winding = glm::determinant(linear) < 0.0F ? -1.0F : 1.0F;
  }
};

}  // namespace foveola
