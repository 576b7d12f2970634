// How next-event estimation draws light. What is not the usual way is there to measure what the
// usual way gains.
#pragma once

#include <cstdint>

namespace foveola {

/// How a light is drawn where there are several.
enum class LightSelection : std::uint8_t {
  usual,           ///< many lights by what they may give to the shading point
  by_power_alone,  ///< wherever the shading point is
  /// Each emissive triangle, point, spot and sun is as likely as any other, and as the environment.
  uniform,
};

struct LightSampling {
  LightSelection selection = LightSelection::usual;
  /// Points are uniform in the area of emissive triangles, even of those that are near.
  bool triangles_by_area = false;
  /// Directions to the environment have the density cosine / pi around the surface's normal,
  /// wherever the sky is bright.
  bool environment_by_cosine = false;
  /// Of the usual selection, which lights reach which part of the scene is learned: see
  /// PathTracer::learn_lights().
  bool learns = true;

  bool operator==(const LightSampling&) const = default;
};

}  // namespace foveola
