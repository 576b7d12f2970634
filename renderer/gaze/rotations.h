// Rotations between directions as vectors: along the axis, right-handed, with the angle as length.
#pragma once

#include <cmath>

#include "renderer/base/vec.h"

namespace foveola {

/// The shortest rotation from one unit vector to another, in radians; zero if they are opposite,
/// where it is ambiguous.
inline DVec3 rotation_between(const DVec3& from, const DVec3& to) {
  const DVec3 normal = glm::cross(from, to);
  const double sine = glm::length(normal);
  return sine > 0.0 ? normal * (std::atan2(sine, glm::dot(from, to)) / sine) : DVec3(0.0);
}

/// `direction`, rotated.
inline DVec3 rotated(const DVec3& direction, const DVec3& rotation_rad) {
  const double angle_rad = glm::length(rotation_rad);
  return angle_rad > 0.0 ? glm::angleAxis(angle_rad, rotation_rad / angle_rad) * direction
                         : direction;
}

}  // namespace foveola
