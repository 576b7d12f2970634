#include "renderer/image/encoded_image.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "renderer/base/work/work_scope.h"
#include "renderer/image/radiance_picture.h"

namespace foveola {
namespace {

constexpr unsigned bit(ImageFormats use) { return 1U << static_cast<unsigned>(use); }
constexpr unsigned for_pictures = bit(ImageFormats::picture) | bit(ImageFormats::environment);
constexpr unsigned for_obj = for_pictures | bit(ImageFormats::any_texture);
constexpr unsigned for_textures = for_obj | bit(ImageFormats::gltf_texture);

/// A file format, recognised by its first bytes, and its maximum compression.
struct Format {
  const char* name;  ///< OpenImageIO's name
  std::string_view magic;
  unsigned uses;  ///< one bit per ImageFormats
  std::size_t max_pixels_per_byte;
};

constexpr std::size_t any_number = std::numeric_limits<std::uint32_t>::max();

/// A small file must not request much memory. Deflate shrinks to no less than 1/1032 (zlib,
/// "Technical Details"), and a PNG has eight pixels to the byte at most, as have EXR's blocks of 64
/// pixels and TIFF; such a block takes a JPEG at least a bit; a run of 127 pixels takes an HDR two
/// bytes for each of four channels, one of 255 a BMP two bytes, one of 128 a TGA two bytes; the
/// 4096 pixels that GIF's longest word stands for take 12 bits.
constexpr std::array<Format, 10> formats = {
    {{"png", "\x89PNG", for_textures, 8 * 1032},
     {"jpeg", "\xFF\xD8\xFF", for_textures, 8 * 64},
     {"webp", "RIFF", for_textures, any_number},
     {"bmp", "BM", for_obj, 128},
     {"gif", "GIF8", for_obj, 2731},
     {"tiff", {"II*\0", 4}, for_obj, 8 * 1032},
     {"tiff", {"MM\0*", 4}, for_obj, 8 * 1032},
     {"openexr", "\x76\x2F\x31\x01", for_pictures, 8 * 1032},
     {"hdr", "#?", for_pictures, 16},
     {"pnm", "P", for_pictures, 8}}};

constexpr Format targa = {"targa", "", for_obj, 64};

/// TGA files have no signature: their header (Truevision, "TGA File Format Specification" 2.0) is
/// accepted if all its values are possible.
bool is_targa(std::span<const unsigned char> encoded) {
  constexpr std::size_t header_size = 18;
  constexpr std::array<unsigned char, 6> kinds = {1, 2, 3, 9, 10, 11};
  constexpr std::array<unsigned char, 5> depths = {8, 15, 16, 24, 32};
  return encoded.size() > header_size && encoded[1] <= 1 &&
         std::ranges::count(kinds, encoded[2]) == 1 && std::ranges::count(depths, encoded[16]) == 1;
}

const char* refusal_of(ImageFormats allowed) {
  switch (allowed) {
    case ImageFormats::gltf_texture:
      return "is not a PNG, JPEG or WebP image";
    case ImageFormats::environment:
    case ImageFormats::picture:
      return "is not an EXR, HDR, PNG, JPEG, WebP, BMP, GIF, TGA, TIFF or PNM image";
    case ImageFormats::any_texture:
      break;
  }
  return "is not a PNG, JPEG, WebP, BMP, GIF, TGA or TIFF image";
}

/// Only few formats are passed to a decoder.
const Format& format_of(std::span<const unsigned char> encoded, ImageFormats allowed) {
  const std::string_view bytes(reinterpret_cast<const char*>(encoded.data()), encoded.size());
  const unsigned uses = bit(allowed);
  for (const Format& format : formats) {
    if (bytes.starts_with(format.magic) && (format.uses & uses) != 0) {
      return format;
    }
  }
  if ((targa.uses & uses) != 0 && is_targa(encoded)) {
    return targa;
  }
  if (bytes.starts_with("\xABKTX 20\xBB")) {
    throw std::runtime_error("is a KTX2 image, which is not read: export it as PNG or JPEG");
  }
  throw std::runtime_error(refusal_of(allowed));
}

/// Walks the chunks: length, type, content, checksum (PNG specification, section 5.3). libpng
/// leaves a reader of a truncated file by a long jump, past all destructors.
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

/// libjpeg paints the missing part of a cut file grey and reports success. Compressed data never
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

std::uint32_t little_endian(std::span<const unsigned char> encoded, std::size_t at,
                            std::size_t bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    value |= static_cast<std::uint32_t>(encoded[at + i]) << 8U * i;
  }
  return value;
}

/// The number of pixels that a WebP image announces (RFC 9649, sections 2.5, 2.6 and 2.7).
std::size_t webp_pixels(std::span<const unsigned char> encoded) {
  constexpr std::size_t shortest = 30;
  const std::string_view bytes(reinterpret_cast<const char*>(encoded.data()), encoded.size());
  if (bytes.size() < shortest || bytes.substr(8, 4) != "WEBP") {
    throw std::runtime_error("is damaged: the WebP image is incomplete");
  }
  const std::string_view chunk = bytes.substr(12, 4);
  if (chunk == "VP8X") {
    return (std::size_t{little_endian(encoded, 24, 3)} + 1) * (little_endian(encoded, 27, 3) + 1);
  }
  if (chunk == "VP8L") {
    const std::uint32_t sides = little_endian(encoded, 21, 4);
    return (std::size_t{sides & 0x3FFFU} + 1) * ((sides >> 14U & 0x3FFFU) + 1);
  }
  return std::size_t{little_endian(encoded, 26, 2) & 0x3FFFU} *
         (little_endian(encoded, 28, 2) & 0x3FFFU);
}

void require_modest_webp(std::span<const unsigned char> encoded) {
  constexpr std::size_t max_pixels = std::size_t{1} << 26;
  if (const std::size_t pixels = webp_pixels(encoded); pixels > max_pixels) {
    throw std::runtime_error(
        fmt::format("has {} pixels; up to {} of a WebP image are read", pixels, max_pixels));
  }
}

void require_whole(std::span<const unsigned char> encoded, std::string_view format) {
  if (format == "png") {
    require_whole_png(encoded);
  } else if (format == "jpeg") {
    require_whole_jpeg(encoded);
  } else if (format == "webp") {
    require_modest_webp(encoded);
  }
}

void require_plausible_size(const ImageHeader& header, const Format& format,
                            std::size_t encoded_size) {
  constexpr std::size_t always_shown = std::size_t{1} << 26;  // a file may hold a part of them
  const std::size_t max_stored = format.max_pixels_per_byte * encoded_size;
  const std::size_t shown = static_cast<std::size_t>(header.width) * header.height;
  if (header.stored_pixels > max_stored || shown > std::max(always_shown, max_stored)) {
    throw std::runtime_error(fmt::format("is damaged: {} bytes cannot hold {} pixels", encoded_size,
                                         std::max(header.stored_pixels, shown)));
  }
}

void require_sensible(const ImageHeader& header, ImageFormats allowed) {
  const int longest_side = allowed == ImageFormats::picture ? 65536 : 16384;
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
  std::unique_ptr<ImageReader> image =
      std::string_view(format.name) == "hdr"
          ? open_radiance_picture(encoded)
          : image_codec().open_bytes(encoded, format.name, is_work_stopped);
  require_sensible(image->header(), allowed);
  require_plausible_size(image->header(), format, encoded.size());
  return image;
}

}  // namespace foveola
