// What the film asks of the tracer: one numbered sample of one pixel.
#pragma once

#include <cstdint>

#include "renderer/base/vec.h"

namespace foveola {

/// Trace a path along `direction` (unit length, world) from the viewpoint. `pixel` (y * width + x)
/// and `sample_number` (how many samples that pixel was given before) key its random numbers, so
/// the radiance is a function of the job and the seed alone.
struct SampleJob {
  Vec3 direction{0.0F, 0.0F, -1.0F};
  std::uint32_t pixel = 0;
  std::uint32_t sample_number = 0;
};

}  // namespace foveola
