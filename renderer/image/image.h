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

/// A display's image: sRGB in 8 bits per channel; a pixel's bytes from the lowest are red, green,
/// blue and 255.
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
  /// Variance of the luminances of each pixel's samples; 0 with fewer than two. Empty if unknown.
  std::vector<float> variances;
};

}  // namespace foveola
