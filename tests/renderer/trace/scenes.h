// Small scenes that the tests build in code.
#pragma once

#include "renderer/stability/shapes.h"

namespace foveola {

/// Black but for its coat, and shining.
inline Material emitter(float radiance, bool double_sided = false) {
  Material material = dielectric(0.0F);
  material.emission = Rgb(radiance);
  material.double_sided = double_sided;
  return material;
}

}  // namespace foveola
