#include "renderer/image/radiance_picture.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/base/work/work_scope.h"

namespace foveola {
namespace {

constexpr std::string_view xyze = "32-bit_rle_xyze";

struct RadianceHeader {
  Rgb multiplied_by{1.0F};
  bool is_xyz = false;
  std::optional<std::array<float, 8>> chromaticities;
  // The order of the scanlines.
  bool is_transposed = false;  ///< a scanline is a column
  bool runs_left = false;
  bool runs_up = false;
};

std::vector<float> numbers_in(std::string_view text, std::size_t count) {
  std::istringstream words{std::string(text)};
  std::vector<float> numbers(count);
  for (float& number : numbers) {
    if (!(words >> number)) {
      throw std::runtime_error("is damaged: a line of its header has too few numbers");
    }
  }
  return numbers;
}

/// Factors of red, green and blue: one for each, or one for all.
Rgb factors_in(std::string_view text, std::size_t count) {
  const std::vector<float> numbers = numbers_in(text, count);
  if (*std::ranges::min_element(numbers) <= 0.0F) {
    throw std::runtime_error("is damaged: its EXPOSURE or COLORCORR is not a positive number");
  }
  return {numbers.front(), numbers[count / 2], numbers.back()};
}

/// The lines up to the one after an empty line, which has the resolution: "-Y 512 +X 1024".
RadianceHeader read_header(std::string_view text) {
  RadianceHeader header;
  const auto take_line = [&text] {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
  };
  while (!text.empty()) {
    const std::string_view line = take_line();
    if (line.empty() || line == "\r") {
      break;
    }
    const std::string_view value = line.substr(std::min(line.find('='), line.size() - 1) + 1);
    if (line.starts_with("EXPOSURE=")) {
      header.multiplied_by *= factors_in(value, 1);
    } else if (line.starts_with("COLORCORR=")) {
      header.multiplied_by *= factors_in(value, 3);
    } else if (line.starts_with("PRIMARIES=")) {
      std::ranges::copy(numbers_in(value, 8), header.chromaticities.emplace().begin());
    } else if (line.starts_with("FORMAT=")) {
      header.is_xyz = value.starts_with(xyze);
    }
  }
  const std::string_view resolution = take_line();
  header.is_transposed = resolution.find('X') < resolution.find('Y');
  header.runs_left = resolution.find("-X") != std::string_view::npos;
  header.runs_up = resolution.find("+Y") != std::string_view::npos;
  return header;
}

/// OpenImageIO reads only RGBE, whose encoding equals XYZE's.
std::vector<unsigned char> called_rgbe(std::span<const unsigned char> encoded) {
  std::string text(reinterpret_cast<const char*>(encoded.data()), encoded.size());
  text.replace(text.find(xyze), xyze.size(), "32-bit_rle_rgbe");
  return {text.begin(), text.end()};
}

class RadiancePicture : public ImageReader {
 public:
  explicit RadiancePicture(std::span<const unsigned char> encoded)
      : radiance_(read_header({reinterpret_cast<const char*>(encoded.data()), encoded.size()})),
        rgbe_(radiance_.is_xyz ? called_rgbe(encoded) : std::vector<unsigned char>()),
        stored_(
            image_codec().open_bytes(radiance_.is_xyz ? rgbe_ : encoded, "hdr", is_work_stopped)),
        header_(stored_->header()) {
    header_.is_xyz = radiance_.is_xyz;
    header_.chromaticities = radiance_.chromaticities;
    if (radiance_.is_transposed) {
      std::swap(header_.width, header_.height);
    }
  }

  const ImageHeader& header() const override { return header_; }

  void read_bytes(std::uint8_t* values) override { stored_->read_bytes(values); }

  void read_floats(int first, int count, float* values, std::size_t stride) override {
    const auto channels = static_cast<std::size_t>(count);
    std::vector<float> stored(header_.stored_pixels * channels);
    stored_->read_floats(first, count, stored.data(), channels);
    for (int y = 0; y < header_.height; ++y) {
      for (int x = 0; x < header_.width; ++x, values += stride) {
        const float* const pixel = stored.data() + stored_pixel(x, y) * channels;
        for (int i = 0; i < count; ++i) {
          values[i] = pixel[i] / radiance_.multiplied_by[first + i];
        }
      }
    }
  }

 private:
  std::size_t stored_pixel(int x, int y) const {
    const int column = radiance_.runs_left ? header_.width - 1 - x : x;
    const int row = radiance_.runs_up ? header_.height - 1 - y : y;
    return radiance_.is_transposed
               ? static_cast<std::size_t>(column) * header_.height + static_cast<std::size_t>(row)
               : static_cast<std::size_t>(row) * header_.width + static_cast<std::size_t>(column);
  }

  RadianceHeader radiance_;
  std::vector<unsigned char> rgbe_;
  std::unique_ptr<ImageReader> stored_;
  ImageHeader header_;
};

}  // namespace

std::unique_ptr<ImageReader> open_radiance_picture(std::span<const unsigned char> encoded) {
  return std::make_unique<RadiancePicture>(encoded);
}

}  // namespace foveola
