// Images of weights for importance sampling.
#pragma once

#include <filesystem>
#include <vector>

namespace foveola {

struct WeightImage {
  int width = 0;
  int height = 0;
  std::vector<float> weights;  ///< row by row from the top; finite, >= 0, at least one positive
};

/// The linear luminance of an image file; 8-bit files are sRGB, so that mid-grey (128) weighs 0.22
/// of white. Throws Error if it cannot be read, has more than 64 x 2^20 pixels, a negative or
/// non-finite pixel, or no positive weight.
WeightImage read_weights(const std::filesystem::path& path);

}  // namespace foveola
