// Images in memory: rows of linear colours, first row at the top.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<Rgb> pixels;

  RgbImage() = default;
  RgbImage(int width_px, int height_px)
      : width(width_px),
        height(height_px),
        pixels(static_cast<std::size_t>(width_px) * height_px) {}

  Rgb& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const Rgb& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// What a display is given: sRGB in 8 bits a channel, red in a pixel's lowest byte, then green and
/// blue; the highest is 255.
struct ByteImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;

  ByteImage() = default;
  ByteImage(int width_px, int height_px)
      : width(width_px),
        height(height_px),
        pixels(static_cast<std::size_t>(width_px) * height_px) {}
};

/// An image with the number of samples behind each pixel.
struct FilmImage {
  RgbImage color;
  std::vector<std::uint32_t> samples;
  /// Variance of the luminances of each pixel's samples; 0 where there are fewer than two. Empty if
  /// not known.
  std::vector<float> variances;
};

}  // namespace foveola
