#include "renderer/scene/image_decoder.h"

#include <stdexcept>

#include <fmt/format.h>

#include "renderer/scene/encoded_image.h"

namespace foveola {
namespace {

OpenImage open_texture(std::span<const unsigned char> encoded) {
  OpenImage image = open_image(encoded, ImageFormats::texture);
  if (image.spec.nchannels > 4) {
    throw std::runtime_error(fmt::format("has {} channels, not 1 to 4", image.spec.nchannels));
  }
  return image;
}

ImageSize size_of(const OIIO::ImageSpec& spec) {
  return {.width = spec.width, .height = spec.height, .channels = spec.nchannels};
}

}  // namespace

ImageSize size_of_image(std::span<const unsigned char> encoded) {
  return size_of(open_texture(encoded).spec);
}

DecodedImage decode_image(std::span<const unsigned char> encoded) {
  const OpenImage open = open_texture(encoded);
  const OIIO::ImageSpec& spec = open.spec;
  DecodedImage image{
      .width = spec.width, .height = spec.height, .channels = spec.nchannels, .texels = {}};
  const std::size_t bytes = size_of(spec).bytes();
  image.texels.reserve(bytes + bytes / 3 + 64);  // leaves room for a texture's coarser levels
  image.texels.resize(bytes);
  // As they are: OpenImageIO converts even bytes to bytes by way of a buffer of 64 MiB.
  const OIIO::TypeDesc as_bytes =
      spec.format == OIIO::TypeDesc::UINT8 ? OIIO::TypeDesc::UNKNOWN : OIIO::TypeDesc::UINT8;
  if (!open.input->read_image(0, 0, 0, spec.nchannels, as_bytes, image.texels.data())) {
    throw std::runtime_error("is damaged: " + open.input->geterror());
  }
  return image;
}

}  // namespace foveola
