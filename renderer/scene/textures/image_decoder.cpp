#include "renderer/scene/textures/image_decoder.h"

#include <stdexcept>

#include <fmt/format.h>

#include "renderer/base/work/work_scope.h"
#include "renderer/scene/textures/decoded_memory.h"
#include "renderer/scene/textures/srgb.h"

namespace foveola {
namespace {

std::unique_ptr<ImageReader> open_texture(std::span<const unsigned char> encoded,
                                          ImageFormats allowed) {
  std::unique_ptr<ImageReader> image = open_image(encoded, allowed);
  // A tile, which OpenImageIO holds as a whole, may be announced far larger than the image.
  require_modest_memory(image->header().block_bytes, encoded.size());
  if (image->header().channels > 4) {
    throw std::runtime_error(fmt::format("has {} channels, not 1 to 4", image->header().channels));
  }
  return image;
}

ImageSize size_of(const ImageHeader& header) {
  return {.width = header.width, .height = header.height, .channels = header.channels};
}

void encode_floats(ImageReader& floats, DecodedImage& image) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t alpha = channels % 2 == 0 ? channels - 1 : channels;
  std::vector<float> values(image.texels.size());
  floats.read_floats(0, image.channels, values.data(), channels);
  for (std::size_t i = 0; i < values.size(); ++i) {
    image.texels[i] =
        i % channels == alpha ? byte_from_linear(values[i]) : srgb_byte_from_linear(values[i]);
  }
}

}  // namespace

ImageSize size_of_image(std::span<const unsigned char> encoded, ImageFormats allowed) {
  return size_of(open_texture(encoded, allowed)->header());
}

DecodedImage decode_image(std::span<const unsigned char> encoded, ImageFormats allowed,
                          bool encodes_srgb) {
  const std::unique_ptr<ImageReader> open = open_texture(encoded, allowed);
  const ImageHeader& header = open->header();
  DecodedImage image{
      .width = header.width, .height = header.height, .channels = header.channels, .texels = {}};
  const std::size_t bytes = size_of(header).bytes();
  image.texels.reserve(bytes + bytes / 3 + 64);  // leaves room for a texture's coarser levels
  image.texels.resize(bytes);
  if (encodes_srgb && header.has_floats) {
    encode_floats(*open, image);
  } else {
    open->read_bytes(image.texels.data());
  }
  throw_if_work_stopped();
  return image;
}

}  // namespace foveola
