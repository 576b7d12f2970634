// The lens before one eye of a headset's display.
#pragma once

#include "renderer/base/vec.h"

namespace foveola {

/// What a headset's lens does to one eye's display: a point at distance d from the lens' axis,
/// measured on the image plane, is seen at distance d (1 + k1 d^2 + k2 d^4) (the radial terms of
/// Brown 1966, "Decentering distortion of lenses"). The image plane lies at distance 1.
struct RadialLens {
  /// Where it meets the display, whose top left corner is (0, 0) and whose bottom right one (1, 1).
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
