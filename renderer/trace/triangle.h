// The geometry of one triangle of a mesh: corners, normal, interpolation, and how exact they are.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// The value at `barycentric` of an attribute that is given at the vertices.
template <typename Value>
Value interpolate(const std::vector<Value>& attribute, const std::array<std::uint32_t, 3>& triangle,
                  const Vec2& barycentric) {
  return (1.0F - barycentric.x - barycentric.y) * attribute[triangle[0]] +
         barycentric.x * attribute[triangle[1]] + barycentric.y * attribute[triangle[2]];
}

struct Triangle {
  Vec3 p0;
  Vec3 p1;
  Vec3 p2;

  Triangle(const Mesh& mesh, std::uint32_t index)
      : p0(mesh.positions[mesh.triangles[index][0]]),
        p1(mesh.positions[mesh.triangles[index][1]]),
        p2(mesh.positions[mesh.triangles[index][2]]) {}

  /// The front face's normal, unit length; not a number without area.
  Vec3 front_normal() const {
    const Vec3 normal = glm::cross(p1 - p0, p2 - p0);
    const float squared_length = glm::dot(normal, normal);
    if (squared_length > 1e-30F && squared_length < 1e30F) {
      return normal / std::sqrt(squared_length);
    }
    // The squares of very small or large sides' products leave the range of a float.
    return glm::normalize(glm::cross(DVec3(p1) - DVec3(p0), DVec3(p2) - DVec3(p0)));
  }

  double area() const {
    return 0.5 * glm::length(glm::cross(DVec3(p1) - DVec3(p0), DVec3(p2) - DVec3(p0)));
  }

  Vec3 at(const Vec2& barycentric) const {
    return (1.0F - barycentric.x - barycentric.y) * p0 + barycentric.x * p1 + barycentric.y * p2;
  }

  /// A bound, in metres, on how far a point computed on the triangle may be off its plane, and a
  /// ray's intersection with it off the true one. Both are sums of a few products of coordinates,
  /// so the bound is a multiple of the largest of them (Pharr et al., Physically Based Rendering,
  /// 4th ed., section 6.8); 32 units in the last place leave a margin for the intersection test.
  float rounding_error() const {
    const Vec3 largest = glm::max(glm::abs(p0), glm::max(glm::abs(p1), glm::abs(p2)));
    return 32.0F * std::numeric_limits<float>::epsilon() * max_component(largest);
  }
};

}  // namespace foveola
