// Angles and directions: world azimuth and elevation, and the true angle between two directions.
#pragma once

#include <cmath>
#include <numbers>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

constexpr double radians(double angle_deg) { return angle_deg * (std::numbers::pi / 180.0); }
constexpr double degrees(double angle_rad) { return angle_rad * (180.0 / std::numbers::pi); }

/// The equivalent angle in [-pi, pi].
inline double wrapped_angle(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

/// A world direction as two angles: azimuth from -Z towards +X in [-pi, pi], elevation from the
/// horizon towards +Y in [-pi/2, pi/2].
struct AzimuthElevation {
  double azimuth_rad = 0.0;
  double elevation_rad = 0.0;
};

/// The unit vector of `angles`.
inline Vec3 direction_from(const AzimuthElevation& angles) {
  const double horizontal = std::cos(angles.elevation_rad);
  return {static_cast<float>(horizontal * std::sin(angles.azimuth_rad)),
          static_cast<float>(std::sin(angles.elevation_rad)),
          static_cast<float>(-horizontal * std::cos(angles.azimuth_rad))};
}

/// The angles of `direction`, which need not have unit length. At the poles the azimuth is 0.
inline AzimuthElevation azimuth_elevation(const Vec3& direction) {
  const double horizontal = std::hypot(static_cast<double>(direction.x), direction.z);
  return {.azimuth_rad = horizontal > 0.0 ? std::atan2(direction.x, -direction.z) : 0.0,
          .elevation_rad = std::atan2(static_cast<double>(direction.y), horizontal)};
}

/// The orientation of a head that looks along `heading` with the horizon level, or tilted to the
/// right by roll_rad: it maps the head's axes (+X right, +Y up, -Z forward) to the world.
inline Quat head_orientation(const AzimuthElevation& heading, double roll_rad = 0.0) {
  // Positive azimuth turns from -Z towards +X, which about +Y is a negative rotation.
  const Quat turn = glm::angleAxis(static_cast<float>(-heading.azimuth_rad), Vec3(0, 1, 0));
  const Quat nod = glm::angleAxis(static_cast<float>(heading.elevation_rad), Vec3(1, 0, 0));
  const Quat tilt = glm::angleAxis(static_cast<float>(roll_rad), Vec3(0, 0, -1));
  return turn * nod * tilt;
}

/// Roll of `head` to the right from a level horizon, in [-pi, pi].
inline double roll_of(const Quat& head) {
  const Quat level = head_orientation(azimuth_elevation(head * Vec3(0.0F, 0.0F, -1.0F)));
  const Quat tilt = glm::conjugate(level) * head;
  return wrapped_angle(2.0 * std::atan2(-static_cast<double>(tilt.z), tilt.w));
}

/// The true angle between two directions in radians, in [0, pi]; accurate at both ends, where the
/// arc cosine of a dot product is not (Kahan, "How futile are mindless assessments of roundoff in
/// floating-point computation?", section 12).
inline double angle_between(const Vec3& a, const Vec3& b) {
  const DVec3 unit_a = glm::normalize(DVec3(a));
  const DVec3 unit_b = glm::normalize(DVec3(b));
  return 2.0 * std::atan2(glm::length(unit_a - unit_b), glm::length(unit_a + unit_b));
}

/// Two unit vectors that complete the unit vector `n` to a right-handed orthonormal frame
/// (tangent, bitangent, n), without a branch on its direction (Duff et al. 2017, "Building an
/// Orthonormal Basis, Revisited").
/// Number: float, or Floats.
template <typename Number>
struct FrameOf {
  using Vector = Vec3Of<Number>;

  Vector tangent;
  Vector bitangent;
  Vector normal;

  explicit FrameOf(const Vector& n) : normal(n) {
    const Number sign = with_sign(1.0F, n.z);
    const Number a = -1.0F / (sign + n.z);
    const Number b = n.x * n.y * a;
    tangent = {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x};
    bitangent = {b, sign + n.y * n.y * a, -n.y};
  }

  Vector to_world(const Vector& local) const {
    return local.x * tangent + local.y * bitangent + local.z * normal;
  }
  Vector to_local(const Vector& world) const {
    return {dot(world, tangent), dot(world, bitangent), dot(world, normal)};
  }
};
using Frame = FrameOf<float>;
using Frames = FrameOf<Floats>;

/// A headset lens before one eye's display. A point at distance d from the lens' axis on the image
/// plane (at distance 1) is seen at distance d (1 + k1 d^2 + k2 d^4): the radial terms of Brown
/// 1966, "Decentering distortion of lenses".
struct RadialLens {
  /// Where the axis meets the display: (0, 0) is its top left corner, (1, 1) the bottom right one.
  Vec2 axis{0.5F, 0.5F};
  float k1 = 0.0F;
  float k2 = 0.0F;

  bool operator==(const RadialLens&) const = default;
};

/// The same lens before the other eye.
inline RadialLens mirrored(RadialLens lens) {
  lens.axis.x = 1.0F - lens.axis.x;
  return lens;
}

}  // namespace foveola
