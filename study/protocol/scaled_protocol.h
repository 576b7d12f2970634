// The same study on fewer pixels and a slower machine, so that simulating it takes less.
#pragma once

#include "study/protocol/protocol.h"

namespace foveola::study {

/// The protocol with `scale` times fewer pixels in the film and in the display's view, those of
/// overrides too, and as many times fewer samples per second: a pixel has the noise that it had at
/// the same second. Sides are rounded, and the machine is as much slower as the rounded film is
/// smaller. At scale 1 all stays as it is. Throws UsageError if scale is below 1 or not finite, or
/// if so few pixels would be left that they show nothing.
Protocol scaled_protocol(Protocol protocol, double scale);

}  // namespace foveola::study
