// Where a sampler sends its samples, over a view.
#pragma once

#include "renderer/view/view_sampler.h"
#include "renderer/window/view_renderer.h"

namespace foveola {

/// The sampler's density by its logarithm: 0 at a hundredth of what a uniform sampler of the sphere
/// has, 1 at a hundred times that.
DensityMap density_map(const ViewSampler& sampler, const Viewport& viewport, int width, int height);

}  // namespace foveola
