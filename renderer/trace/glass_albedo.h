// How much light the rough surface of a solid dielectric reflects and transmits at its first
// bounce: the rest bounces on between microfacets and is given back.
#pragma once

#include <vector>

#include "renderer/base/parallel.h"

namespace foveola {

/// The albedo of rough glass of one index of refraction, seen from outside and from inside. Within
/// 5e-4 of the integral.
class GlassAlbedo {
 public:
  /// ior: > 1, of the inside over the outside.
  GlassAlbedo(float ior, const Workers& workers);

  float ior() const { return ior_; }

  /// Reflected and transmitted share of the power. roughness: in [smallest_roughness, 1]. cosine:
  /// between the normal and the direction, in [0, 1].
  float at(float roughness, float cosine, bool from_inside) const;

 private:
  float ior_;
  std::vector<float> nodes_;  ///< side, roughness, position of the cosine
};

}  // namespace foveola
