// A small picture of what a viewport shows, without a film: for measuring what is seen, and for
// judging it by eye.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/trace/path_tracer.h"
#include "renderer/view/viewport.h"

namespace foveola {

struct SmallPictureSettings {
  IVec2 size{1};  ///< pixels
  std::uint32_t samples_per_pixel = 16;
  /// Its seed is also that of the samples' places in their pixels, and the angle of a pixel is the
  /// picture's own.
  TraceSettings trace;
};

/// The mean radiance of each pixel, row after row from the top left; samples that are not finite
/// count as black. Equal on any number of threads.
std::vector<DVec3> small_picture(const PathTracer& tracer, const Vec3& viewpoint,
                                 const Viewport& viewport, SmallPictureSettings settings,
                                 const Workers& workers);

}  // namespace foveola
