// Bounds of one light or a group of lights: position, emission directions and intensity.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

struct DirectionCone {
  Vec3 axis;               ///< unit length
  float one_minus_cosine;  ///< 1 - cos(half angle), exact where the cosine is next to 1

  /// sine_squared: of the half angle, which is at most a right one.
  static DirectionCone with_sine_squared(const Vec3& axis, float sine_squared) {
    return {axis, sine_squared / (1.0F + std::sqrt(std::max(0.0F, 1.0F - sine_squared)))};
  }

  /// The cone's solid angle in steradians.
  float solid_angle() const { return 2.0F * std::numbers::pi_v<float> * one_minus_cosine; }

  struct Sample {
    Vec3 direction;  ///< unit length
    float cosine;    ///< cosine of its angle with the axis
    float sine_squared;
  };
  /// u: in the unit square.
  Sample sample(const Vec2& u) const {
    const float below_one = u.x * one_minus_cosine;
    const float sine_squared = below_one * (2.0F - below_one);
    const float sine = std::sqrt(sine_squared);
    const float azimuth = 2.0F * std::numbers::pi_v<float> * u.y;
    const Vec3 local(sine * std::cos(azimuth), sine * std::sin(azimuth), 1.0F - below_one);
    return {glm::normalize(Frame(axis).to_world(local)), local.z, sine_squared};
  }
};

/// The lights emit within a cone of half angle falloff around each direction of a cone of half
/// angle spread around the axis (Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights
/// with Adaptive Tree Splitting", section 4.1).
struct LightBounds {
  Bounds box;
  DVec3 axis{0.0, 0.0, 1.0};  ///< unit length
  double spread_rad = 0.0;    ///< in [0, pi]
  double falloff_rad = 0.0;   ///< in [0, pi]
  bool two_sided = false;     ///< also emits against the axis
  /// Luminous intensity in the brightest direction, summed over the lights; 0: no emission.
  double intensity = 0.0;

  DVec3 centre() const { return 0.5 * (DVec3(box.lower) + DVec3(box.upper)); }
  /// Radius of the box's bounding sphere.
  double radius() const { return 0.5 * glm::length(DVec3(box.upper) - DVec3(box.lower)); }
};

/// Bounds of everything in `a` and in `b`.
LightBounds merge(const LightBounds& a, const LightBounds& b);

/// Solid angle of the emission directions, weighted by their cosine falloff, in steradians (the
/// measure of Conty Estevez and Kulla 2018, equation 1).
double orientation_measure(const LightBounds& bounds);

}  // namespace foveola
