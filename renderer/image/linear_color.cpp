#include "renderer/image/linear_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/work/work_scope.h"
#include "renderer/image/tone_mapping.h"

namespace foveola {
namespace {

constexpr std::array<float, 8> rec709 = {0.64F, 0.33F, 0.30F,   0.60F,
                                         0.15F, 0.06F, 0.3127F, 0.3290F};

/// Red, green and blue of a layer, by index; -1: missing.
std::array<int, 3> layer_channels(const std::vector<std::string>& names, const std::string& layer) {
  std::array<int, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = std::ranges::find(names, layer + "RGB"[i]);
    channels[i] = found == names.end() ? -1 : static_cast<int>(found - names.begin());
  }
  return channels;
}

bool are_there(const std::array<int, 3>& channels) {
  return *std::ranges::min_element(channels) >= 0;
}

/// The layers with red, green and blue, "ViewLayer.Combined." for instance.
std::vector<std::string> color_layers(const std::vector<std::string>& names) {
  std::vector<std::string> layers;
  for (const std::string& name : names) {
    if (name.ends_with(".R")) {
      const std::string layer = name.substr(0, name.size() - 1);
      if (are_there(layer_channels(names, layer))) {
        layers.push_back(layer);
      }
    }
  }
  return layers;
}

std::array<int, 3> color_channels(const std::vector<std::string>& names) {
  if (names.size() < 3) {
    return {0, 0, 0};
  }
  if (const std::array<int, 3> plain = layer_channels(names, ""); are_there(plain)) {
    return plain;
  }
  std::vector<std::string> layers = color_layers(names);
  const auto combined = std::ranges::find_if(
      layers, [](const std::string& layer) { return layer.ends_with("Combined."); });
  if (combined != layers.end()) {
    return layer_channels(names, *combined);
  }
  if (layers.size() != 1) {
    throw std::runtime_error(
        fmt::format("has no channels R, G and B but {}; save one layer alone", names));
  }
  return layer_channels(names, layers.front());
}

/// Columns: CIE X, Y, Z of each primary, which add up to the white of luminance 1.
DMat3 xyz_from_rgb(const std::array<float, 8>& chromaticities) {
  const auto xyz = [&](std::size_t i) {
    const double x = chromaticities[2 * i];
    const double y = chromaticities[2 * i + 1];
    return DVec3(x, y, 1.0 - x - y);
  };
  const DMat3 primaries(xyz(0), xyz(1), xyz(2));
  const DVec3 scales = glm::inverse(primaries) * (xyz(3) / xyz(3).y);
  return {primaries[0] * scales.r, primaries[1] * scales.g, primaries[2] * scales.b};
}

/// By Bradford's adaptation from one white to the other (Lindbloom, "Chromatic Adaptation").
DMat3 adaptation(const DVec3& from_white, const DVec3& to_white) {
  const DMat3 cones = glm::transpose(
      DMat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const DVec3 ratio = (cones * to_white) / (cones * from_white);
  return glm::inverse(cones) *
         DMat3(DVec3(ratio.x, 0, 0), DVec3(0, ratio.y, 0), DVec3(0, 0, ratio.z)) * cones;
}

/// Not finite if the primaries or the white are invalid.
Mat3 rec709_from_primaries(const std::array<float, 8>& chromaticities) {
  const DMat3 xyz_from_rec709 = xyz_from_rgb(rec709);
  const DMat3 xyz_from_file = xyz_from_rgb(chromaticities);
  const DVec3 white(1.0);
  return Mat3(glm::inverse(xyz_from_rec709) *
              adaptation(xyz_from_file * white, xyz_from_rec709 * white) * xyz_from_file);
}

/// nullopt if the file's primaries are those of Rec. 709, or invalid.
std::optional<Mat3> rec709_from_file(const ImageHeader& header) {
  if (header.is_xyz) {
    return Mat3(glm::inverse(xyz_from_rgb(rec709)));
  }
  if (!header.chromaticities || !has_valid_primaries(header)) {
    return std::nullopt;
  }
  constexpr float same = 1e-3F;
  const bool are_rec709 = std::equal(rec709.begin(), rec709.end(), header.chromaticities->begin(),
                                     [](float a, float b) { return std::abs(a - b) < same; });
  return are_rec709 ? std::nullopt : std::optional(rec709_from_primaries(*header.chromaticities));
}

}  // namespace

bool has_valid_primaries(const ImageHeader& header) {
  if (!header.chromaticities) {
    return true;
  }
  const Mat3 matrix = rec709_from_primaries(*header.chromaticities);
  return is_finite(matrix[0]) && is_finite(matrix[1]) && is_finite(matrix[2]);
}

RgbImage read_linear_color(ImageReader& image) {
  const ImageHeader& header = image.header();
  const std::array<int, 3> channels = color_channels(header.channel_names);
  RgbImage color(header.width, header.height);
  constexpr std::size_t stride = sizeof(Rgb) / sizeof(float);
  const bool is_grey = channels[2] == channels[0];  // a single channel stands for all three
  const bool are_neighbours = channels[1] == channels[0] + 1 && channels[2] == channels[0] + 2;
  // Reads R, G and B in one call if they are adjacent. Only EXR, which may order them otherwise,
  // allows several calls.
  const int channels_per_read = are_neighbours ? 3 : 1;
  for (int i = 0; i < (is_grey ? 1 : 3); i += channels_per_read) {
    image.read_floats(channels[static_cast<std::size_t>(i)], channels_per_read, &color.pixels[0][i],
                      stride);
    throw_if_work_stopped();
  }
  if (is_grey) {
    std::ranges::transform(color.pixels, color.pixels.begin(),
                           [](const Rgb& pixel) { return Rgb(pixel.r); });
  }
  if (!header.has_floats) {
    for (Rgb& pixel : color.pixels) {
      pixel = {linear_from_srgb(pixel.r), linear_from_srgb(pixel.g), linear_from_srgb(pixel.b)};
    }
  }
  if (const std::optional<Mat3> matrix = rec709_from_file(header)) {
    std::transform(color.pixels.begin(), color.pixels.end(), color.pixels.begin(),
                   [&](const Rgb& pixel) { return *matrix * pixel; });
  }
  return color;
}

}  // namespace foveola
