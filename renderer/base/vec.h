// The program's vector types: GLM's under short names.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace foveola {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using DVec2 = glm::dvec2;
using DVec3 = glm::dvec3;
using DMat3 = glm::dmat3;
using IVec2 = glm::ivec2;
using Mat3 = glm::mat3;
/// Three columns of two numbers: an affine map of the plane.
using Mat3x2 = glm::mat3x2;
using Mat4 = glm::mat4;
using DMat4 = glm::dmat4;
using Quat = glm::quat;

/// Linear Rec. 709 radiance, reflectance or throughput.
using Rgb = glm::vec3;

/// Relative luminance of a linear Rec. 709 colour (ITU-R BT.709-6, item 3.2), or of lanes of them.
template <typename Vector>
inline auto luminance(const Vector& rgb) {
  return 0.2126F * rgb.x + 0.7152F * rgb.y + 0.0722F * rgb.z;
}

inline double luminance(const DVec3& rgb) {
  return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
}

inline float max_component(const Vec3& v) { return glm::max(v.x, glm::max(v.y, v.z)); }

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace foveola
