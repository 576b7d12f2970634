#include "renderer/scene/encoded_image.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace foveola {
namespace {

constexpr int longest_side = 16384;

/// A file format, by its first bytes, and what it can say at most.
struct Format {
  const char* name;  ///< OpenImageIO's
  std::string_view magic;
  bool holds_light;  ///< floats, beyond what is displayed
  std::size_t most_pixels_per_byte;
};

/// A small file must not ask for much memory. Deflate shrinks to no less than 1/1032 (zlib,
/// "Technical Details"), and a PNG has eight pixels to the byte at most, as have EXR's blocks of 64
/// pixels; such a block takes a JPEG at least a bit; a run of 127 pixels takes an HDR two bytes for
/// each of four channels.
constexpr std::array<Format, 4> formats = {{{"png", "\x89PNG", false, 8 * 1032},
                                            {"jpeg", "\xFF\xD8\xFF", false, 8 * 64},
                                            {"openexr", "\x76\x2F\x31\x01", true, 8 * 1032},
                                            {"hdr", "#?", true, 16}}};

/// Only few formats are let near a decoder.
const Format& format_of(std::span<const unsigned char> encoded, ImageFormats allowed) {
  const std::string_view bytes(reinterpret_cast<const char*>(encoded.data()), encoded.size());
  for (const Format& format : formats) {
    if (bytes.starts_with(format.magic) &&
        (allowed == ImageFormats::environment || !format.holds_light)) {
      return format;
    }
  }
  throw std::runtime_error(allowed == ImageFormats::environment
                               ? "is no EXR, HDR, PNG or JPEG image"
                               : "is neither a PNG nor a JPEG image");
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

void require_whole(std::span<const unsigned char> encoded, std::string_view format) {
  if (format == "png") {
    require_whole_png(encoded);
  } else if (format == "jpeg") {
    require_whole_jpeg(encoded);
  }
}

void require_plausible_size(const ImageHeader& header, const Format& format,
                            std::size_t encoded_size) {
  const std::size_t pixels = static_cast<std::size_t>(header.width) * header.height;
  if (pixels > format.most_pixels_per_byte * encoded_size) {
    throw std::runtime_error(fmt::format("is damaged: {} bytes cannot hold {} x {} pixels",
                                         encoded_size, header.width, header.height));
  }
}

void require_sensible(const ImageHeader& header) {
  if (header.width < 1 || header.height < 1 || header.width > longest_side ||
      header.height > longest_side) {
    throw std::runtime_error(fmt::format("has {} x {} pixels; up to {} on a side are read",
                                         header.width, header.height, longest_side));
  }
  if (header.channels < 1 || !header.is_flat) {
    throw std::runtime_error("is not a flat image");
  }
}

}  // namespace

std::unique_ptr<ImageReader> open_image(std::span<const unsigned char> encoded,
                                        ImageFormats allowed) {
  const Format& format = format_of(encoded, allowed);
  require_whole(encoded, format.name);
  std::unique_ptr<ImageReader> image = image_codec().open_bytes(encoded, format.name);
  require_sensible(image->header());
  require_plausible_size(image->header(), format, encoded.size());
  return image;
}

}  // namespace foveola
