// What is known of one light, or of several together, without asking each: where they are, where
// they shine to, and how much.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// The lights shine in a cone of half angle falloff around each direction of a cone of half angle
/// spread around the axis (Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with
/// Adaptive Tree Splitting", section 4.1).
struct LightBounds {
  Bounds box;
  DVec3 axis{0.0, 0.0, 1.0};  ///< unit length
  double spread_rad = 0.0;    ///< in [0, pi]
  double falloff_rad = 0.0;   ///< in [0, pi]
  bool two_sided = false;     ///< shines against the axis too
  /// Luminous intensity in the brightest direction, summed over the lights; 0: no light at all.
  double intensity = 0.0;

  DVec3 centre() const { return 0.5 * (DVec3(box.lower) + DVec3(box.upper)); }
  /// The radius of the sphere around the box.
  double radius() const { return 0.5 * glm::length(DVec3(box.upper) - DVec3(box.lower)); }
};

/// Bounds of everything in `a` and in `b`.
LightBounds merge(const LightBounds& a, const LightBounds& b);

/// How many directions the lights shine to, weighed by the cosine they fall off with, in steradians
/// (the measure of Conty Estevez and Kulla 2018, equation 1).
double orientation_measure(const LightBounds& bounds);

}  // namespace foveola
