// Directions within an angle of an axis, uniform in solid angle: discs in the sky and seen spheres.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"

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

}  // namespace foveola
