// Decodes encoded images for textures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/image/encoded_image.h"

namespace foveola {

/// 8-bit channels (1: grey; 2: grey, alpha; 3: red, green, blue; 4: red, green, blue, alpha),
/// interleaved, row-major, first row on top. Alpha is not premultiplied.
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

/// The size of decode_image()'s result, from the header of `encoded`. Throws as decode_image does.
ImageSize size_of_image(std::span<const unsigned char> encoded,
                        ImageFormats allowed = ImageFormats::gltf_texture);

/// Decodes an image of one of the formats to its own channels, in 8 bits. encodes_srgb: whether
/// linear colours of floats become sRGB. Throws std::runtime_error that names the fault if it is
/// not an image, damaged, or larger than 16384 pixels on a side.
DecodedImage decode_image(std::span<const unsigned char> encoded,
                          ImageFormats allowed = ImageFormats::gltf_texture,
                          bool encodes_srgb = false);

}  // namespace foveola
