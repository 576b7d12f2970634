// What sample density alone predicts of convergence.
#pragma once

#include <optional>

#include "renderer/measure/region_error.h"
#include "renderer/view/view_sampler.h"

namespace foveola::analysis {

/// How many times fewer samples `method` needs than `baseline` for the same mean squared error in a
/// region of a film of `size`, if all of its pixels are equally noisy and noise falls with their
/// samples: with p the probability that a sample falls into a pixel of weight w,
/// (sum of w / p of the baseline) / (sum of w / p of the method). Both are aimed alike. Empty where
/// one of them never reaches some pixel.
std::optional<double> predicted_speed_up(const ViewSampler& method, const ViewSampler& baseline,
                                         const PixelRegion& region, const IVec2& size);

}  // namespace foveola::analysis
