#include "scenes/modelling/png.h"

#include <csetjmp>
#include <stdexcept>

#include <png.h>

namespace foveola::scenes {
namespace {

bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 255) {
      return false;
    }
  }
  return true;
}

std::vector<std::uint8_t> without_alpha(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb(rgba.size() / 4 * 3);
  for (std::size_t from = 0, to = 0; from < rgba.size(); from += 4, to += 3) {
    rgb[to] = rgba[from];
    rgb[to + 1] = rgba[from + 1];
    rgb[to + 2] = rgba[from + 2];
  }
  return rgb;
}

void append_bytes(png_structp writer, png_bytep data, png_size_t size) {
  auto& file = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(writer));
  const auto* const bytes = reinterpret_cast<const std::byte*>(data);
  file.insert(file.end(), bytes, bytes + size);
}

void flush_nothing(png_structp /*writer*/) {}

/// Grainy textures stay nearly as small with the cheapest filter and the fastest compression as
/// with the best, in a third of the time. Holds nothing that libpng's longjmp would leave behind.
bool write_rows(png_structp writer, png_infop info, const Image& image, int color_type,
                const std::uint8_t* pixels, std::size_t row_size) {
  if (setjmp(png_jmpbuf(writer)) != 0) {
    return false;
  }
  png_set_IHDR(writer, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, color_type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(writer, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  png_set_compression_level(writer, 1);
  png_write_info(writer, info);
  for (int y = 0; y < image.height; ++y) {
    png_write_row(writer, pixels + static_cast<std::size_t>(y) * row_size);
  }
  png_write_end(writer, info);
  return true;
}

}  // namespace

std::vector<std::byte> png_from(const Image& image) {
  const bool opaque = is_opaque(image);
  const std::vector<std::uint8_t> pixels = opaque ? without_alpha(image.rgba) : image.rgba;
  std::vector<std::byte> file;
  file.reserve(pixels.size());
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = writer != nullptr ? png_create_info_struct(writer) : nullptr;
  bool written = false;
  if (info != nullptr) {
    png_set_write_fn(writer, &file, append_bytes, flush_nothing);
    written = write_rows(writer, info, image, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA,
                         pixels.data(), static_cast<std::size_t>(image.width) * (opaque ? 3 : 4));
  }
  png_destroy_write_struct(&writer, &info);
  if (!written) {
    throw std::runtime_error("libpng cannot write a texture");
  }
  return file;
}

}  // namespace foveola::scenes
