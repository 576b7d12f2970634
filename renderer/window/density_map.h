// Where a sampler sends its samples, over a view, and the colours that say how many.
#pragma once

#include <vector>

#include "renderer/view/view_sampler.h"

namespace foveola {

/// Densities over a view, row by row from its top left, 0 the least and 1 the most.
struct DensityMap {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// The sampler's density by its logarithm: 0 at a hundredth of what a uniform sampler of the sphere
/// has, 1 at a hundred times that.
DensityMap density_map(const ViewSampler& sampler, const Viewport& viewport, int width, int height);

/// The colour, sRGB in [0, 1], of a map's value: from blue for 0 over green to red for 1.
Rgb density_color(float value);

}  // namespace foveola
