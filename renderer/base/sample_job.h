// A request of the film to the tracer: one numbered sample of one pixel.
#pragma once

#include <cstdint>

#include "renderer/base/vec.h"

namespace foveola {

/// Asks for a path along `direction` (unit length, world) from the viewpoint. `pixel` (y * width +
/// x) and `sample_number` (the pixel's previous samples) key its random numbers. The radiance thus
/// depends on the job and the seed alone.
struct SampleJob {
  Vec3 direction{0.0F, 0.0F, -1.0F};
  std::uint32_t pixel = 0;
  std::uint32_t sample_number = 0;
};

}  // namespace foveola
