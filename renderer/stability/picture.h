// Small 360-degree pictures whose noise is known, so that two of them can be compared.
#pragma once

#include <string>
#include <vector>

#include "renderer/stability/estimate.h"

namespace foveola {

struct PictureSettings {
  int block = 8;  ///< pixels along a side; divides the effort's width and height
  int max_depth = 6;
  std::uint32_t seed = 0;
};

/// The mean radiance of each block, row by row from the top left, in the convention of the film.
/// Every pixel gets the effort's samples (32 at least), uniformly over its area.
std::vector<RadianceEstimate> render_blocks(const PathTracer& tracer, const Vec3& viewpoint,
                                            const PictureSettings& settings,
                                            const StabilityRun& run);

/// The largest difference between equal blocks of two pictures, in standard errors of that
/// difference. exactness: relative to the block's mean, what is forgiven beside noise.
StabilityFigure picture_difference(std::string name, const std::vector<RadianceEstimate>& picture,
                                   const std::vector<RadianceEstimate>& reference,
                                   double exactness);

}  // namespace foveola
