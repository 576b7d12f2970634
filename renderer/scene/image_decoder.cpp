#include "renderer/scene/image_decoder.h"

#include <stdexcept>

#include <fmt/format.h>

#include "renderer/scene/decoded_memory.h"

namespace foveola {
namespace {

std::unique_ptr<ImageReader> open_texture(std::span<const unsigned char> encoded,
                                          ImageFormats allowed) {
  std::unique_ptr<ImageReader> image = open_image(encoded, allowed);
  // A tile, which OpenImageIO holds as a whole, may be announced far larger than the image.
  require_modest_memory(image->header().tile_bytes, encoded.size());
  if (image->header().channels > 4) {
    throw std::runtime_error(fmt::format("has {} channels, not 1 to 4", image->header().channels));
  }
  return image;
}

ImageSize size_of(const ImageHeader& header) {
  return {.width = header.width, .height = header.height, .channels = header.channels};
}

}  // namespace

ImageSize size_of_image(std::span<const unsigned char> encoded, ImageFormats allowed) {
  return size_of(open_texture(encoded, allowed)->header());
}

DecodedImage decode_image(std::span<const unsigned char> encoded, ImageFormats allowed) {
  const std::unique_ptr<ImageReader> open = open_texture(encoded, allowed);
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
