// A point of a light that stands in the scene, as a place sees it.
#pragma once

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

/// Number: float, or Floats.
template <typename Number>
struct LocalLightSampleOf {
  Vec3Of<Number> to_light{};  ///< from the place to the point, not of unit length
  Number pdf{};               ///< per steradian; without size: a probability; 0: no light
  Vec3Of<Number> radiance{};  ///< without size: the irradiance that it gives head-on
  /// The light has no size.
  MaskOf<Number> is_delta{};
};
using LocalLightSample = LocalLightSampleOf<float>;

}  // namespace foveola
