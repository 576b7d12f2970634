// Scales a study down: fewer pixels and a slower machine, so that simulating it takes less time.
#pragma once

#include "study/protocol/protocol.h"

namespace foveola::study {

/// Returns the protocol with `scale` times fewer pixels in the film and in the display's view, also
/// in overrides, and as many times fewer samples per second: a pixel has the same noise at the same
/// time. Sides are rounded, and the machine is slowed by the ratio of the rounded films. Scale 1
/// changes nothing. Throws UsageError if scale is below 1 or not finite, or if too few pixels
/// remain: below 8 aside, or 500 of a film.
Protocol scaled_protocol(Protocol protocol, double scale);

}  // namespace foveola::study
