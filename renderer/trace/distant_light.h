// What arrives from infinitely far.
#pragma once

#include "renderer/base/vec.h"

namespace foveola {

struct DistantLight {
  Rgb radiance{0.0F};
  float pdf = 0.0F;  ///< per steradian, with which next-event estimation draws its direction
};

}  // namespace foveola
