// Encoded images into textures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/image/encoded_image.h"

namespace foveola {

/// 8-bit channels (1: grey; 2: grey, alpha; 3: red, green, blue; 4: those and alpha, which is not
/// premultiplied), interleaved, row-major, first row on top.
struct DecodedImage {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::uint8_t> texels;
};

struct ImageSize {
  int width = 0;
  int height = 0;
  int channels = 0;

  std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }
  std::size_t bytes() const { return pixels() * static_cast<std::size_t>(channels); }
};

/// What decode_image will return, from the header of `encoded`. Throws as decode_image does.
ImageSize size_of_image(std::span<const unsigned char> encoded,
                        ImageFormats allowed = ImageFormats::gltf_texture);

/// Decodes an image of one of the formats to its own channels; other numbers become 8 bits.
/// encodes_srgb: whether the colours of floats, which are linear, become sRGB. Throws
/// std::runtime_error that says what is wrong if it is none, damaged, or larger than 16384 pixels
/// on a side.
DecodedImage decode_image(std::span<const unsigned char> encoded,
                          ImageFormats allowed = ImageFormats::gltf_texture,
                          bool encodes_srgb = false);

}  // namespace foveola
