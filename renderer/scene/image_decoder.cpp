#include "renderer/scene/image_decoder.h"

#include <stdexcept>

#include <fmt/format.h>

#include "renderer/scene/encoded_image.h"

namespace foveola {
namespace {

std::unique_ptr<ImageReader> open_texture(std::span<const unsigned char> encoded) {
  std::unique_ptr<ImageReader> image = open_image(encoded, ImageFormats::texture);
  if (image->header().channels > 4) {
    throw std::runtime_error(fmt::format("has {} channels, not 1 to 4", image->header().channels));
  }
  return image;
}

ImageSize size_of(const ImageHeader& header) {
  return {.width = header.width, .height = header.height, .channels = header.channels};
}

}  // namespace

ImageSize size_of_image(std::span<const unsigned char> encoded) {
  return size_of(open_texture(encoded)->header());
}

DecodedImage decode_image(std::span<const unsigned char> encoded) {
  const std::unique_ptr<ImageReader> open = open_texture(encoded);
  const ImageHeader& header = open->header();
  DecodedImage image{
      .width = header.width, .height = header.height, .channels = header.channels, .texels = {}};
  const std::size_t bytes = size_of(header).bytes();
  image.texels.reserve(bytes + bytes / 3 + 64);  // leaves room for a texture's coarser levels
  image.texels.resize(bytes);
  open->read_bytes(image.texels.data());
  return image;
}

}  // namespace foveola
