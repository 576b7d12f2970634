#include "renderer/scene/image_decoder.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

namespace foveola {
namespace {

constexpr int longest_side = 16384;

/// OpenImageIO's name of the format. Only the two that glTF has are let near a decoder.
std::string format_of(std::span<const unsigned char> encoded) {
  static constexpr std::array<unsigned char, 4> png = {0x89, 'P', 'N', 'G'};
  static constexpr std::array<unsigned char, 3> jpeg = {0xFF, 0xD8, 0xFF};
  const auto begins_with = [&](std::span<const unsigned char> magic) {
    return encoded.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), encoded.begin());
  };
  if (begins_with(png)) {
    return "png";
  }
  if (begins_with(jpeg)) {
    return "jpeg";
  }
  throw std::runtime_error("is neither a PNG nor a JPEG image");
}

/// Walks the chunks: length, type, content, checksum (PNG specification, section 5.3). libpng
/// leaves a reader that finds the end of the file too early by a long jump, past all destructors.
void require_whole_png(std::span<const unsigned char> encoded) {
  constexpr std::size_t signature_size = 8;
  constexpr std::size_t frame_size = 12;
  std::size_t chunk = signature_size;
  while (chunk + frame_size <= encoded.size()) {
    const unsigned char* header = encoded.data() + chunk;
    if (std::equal(header + 4, header + 8, "IEND")) {
      return;
    }
    const std::size_t length = std::size_t{header[0]} << 24 | std::size_t{header[1]} << 16 |
                               std::size_t{header[2]} << 8 | std::size_t{header[3]};
    chunk += frame_size + length;
  }
  throw std::runtime_error("is damaged: the PNG image is cut off");
}

/// libjpeg paints what is missing of a cut file grey and calls it a picture. Compressed data never
/// holds a marker (ITU-T T.81, section F.1.2.3), so the end of image must follow the last scan.
void require_whole_jpeg(std::span<const unsigned char> encoded) {
  constexpr unsigned char start_of_scan = 0xDA;
  constexpr unsigned char end_of_image = 0xD9;
  for (std::size_t i = encoded.size(); i-- > 1;) {
    if (encoded[i - 1] == 0xFF && encoded[i] == end_of_image) {
      return;
    }
    if (encoded[i - 1] == 0xFF && encoded[i] == start_of_scan) {
      break;
    }
  }
  throw std::runtime_error("is damaged: the JPEG image is cut off");
}

/// A small file must not ask for much memory. Neither format can say so much in so few bytes:
/// deflate
/// shrinks to no less than 1/1032 (zlib, "Technical Details"), and a PNG has eight pixels to the
/// byte at most; a block of 64 pixels takes a JPEG at least a bit.
void require_plausible_size(const OIIO::ImageSpec& spec, const std::string& format,
                            std::size_t encoded_size) {
  const std::size_t pixels = static_cast<std::size_t>(spec.width) * spec.height;
  const std::size_t most = format == "png" ? 8 * 1032 * encoded_size : 8 * 64 * encoded_size;
  if (pixels > most) {
    throw std::runtime_error(fmt::format("is damaged: {} bytes cannot hold {} x {} pixels",
                                         encoded_size, spec.width, spec.height));
  }
}

/// An image whose header has been read and found sensible.
struct OpenImage {
  std::unique_ptr<OIIO::Filesystem::IOMemReader> memory;  ///< read by `input`, so it dies after it
  std::unique_ptr<OIIO::ImageInput> input;
  OIIO::ImageSpec spec;
};

OpenImage open_image(std::span<const unsigned char> encoded) {
  const std::string format = format_of(encoded);
  format == "png" ? require_whole_png(encoded) : require_whole_jpeg(encoded);
  OpenImage image;
  image.memory = std::make_unique<OIIO::Filesystem::IOMemReader>(encoded.data(), encoded.size());
  image.input = OIIO::ImageInput::create(format);
  if (!image.input) {
    throw std::runtime_error("cannot be read: OpenImageIO has no reader for " + format);
  }
  OIIO::ImageSpec wishes;
  wishes["oiio:UnassociatedAlpha"] = 1;
  image.input->set_ioproxy(image.memory.get());
  if (!image.input->open("texture." + format, image.spec, wishes)) {
    throw std::runtime_error("is damaged: " + image.input->geterror());
  }
  const OIIO::ImageSpec& spec = image.spec;
  if (spec.width < 1 || spec.height < 1 || spec.width > longest_side ||
      spec.height > longest_side) {
    throw std::runtime_error(fmt::format("has {} x {} pixels; up to {} on a side are read",
                                         spec.width, spec.height, longest_side));
  }
  if (spec.nchannels < 1 || spec.nchannels > 4) {
    throw std::runtime_error(fmt::format("has {} channels, not 1 to 4", spec.nchannels));
  }
  require_plausible_size(spec, format, encoded.size());
  return image;
}

}  // namespace

std::size_t pixel_count(std::span<const unsigned char> encoded) {
  const OpenImage image = open_image(encoded);
  return static_cast<std::size_t>(image.spec.width) * image.spec.height;
}

DecodedImage decode_image(std::span<const unsigned char> encoded) {
  const OpenImage open = open_image(encoded);
  const OIIO::ImageSpec& spec = open.spec;
  DecodedImage image{
      .width = spec.width, .height = spec.height, .channels = spec.nchannels, .texels = {}};
  const std::size_t bytes = static_cast<std::size_t>(spec.nchannels) * spec.width * spec.height;
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
