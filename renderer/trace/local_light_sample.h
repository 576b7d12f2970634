// A point of a light that stands in the scene, as a place sees it.
#pragma once

#include "renderer/base/vec.h"

namespace foveola {

struct LocalLightSample {
  Vec3 to_light{0.0F};  ///< from the place to the point, not of unit length
  float pdf = 0.0F;     ///< per steradian; without size: a probability
  Rgb radiance{0.0F};   ///< without size: the irradiance that it gives head-on
  /// A light without size, or one that no ray sees.
  bool is_delta = false;
};

}  // namespace foveola
