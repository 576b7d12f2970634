#include "renderer/scene/environment.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/image/encoded_image.h"
#include "renderer/image/linear_color.h"
#include "renderer/scene/textures/decoded_memory.h"

namespace foveola {
namespace {

Environment decode(std::span<const unsigned char> encoded, const std::string& file,
                   Warnings& warnings) {
  const std::unique_ptr<ImageReader> image = open_image(encoded, ImageFormats::environment);
  const ImageHeader& header = image->header();
  const std::size_t pixels = static_cast<std::size_t>(header.width) * header.height;
  // A block, which OpenImageIO holds as a whole, may be announced far larger than the image.
  require_modest_memory(std::max(pixels * sizeof(Rgb), header.block_bytes), encoded.size());
  if (!has_valid_primaries(header)) {
    warnings.add(
        "the environment states primaries that span no colour space: it is taken for "
        "Rec. 709",
        file);
  }
  RgbImage color = read_linear_color(*image);
  Environment environment;
  environment.map_width = color.width;
  environment.map_height = color.height;
  environment.map = std::move(color.pixels);
  return environment;
}

/// A cube map is not an equirect image, in any layout.
void warn_of_other_projections(const Environment& environment, const std::string& file,
                               Warnings& warnings) {
  constexpr int rounding_px = 2;
  if (std::abs(environment.map_width - 2 * environment.map_height) > rounding_px) {
    warnings.add(fmt::format("the environment has {} x {} pixels, not a panorama of 2 to 1: it is "
                             "stretched over the whole sphere",
                             environment.map_width, environment.map_height),
                 file);
  }
}

/// The replacement of infinity, which stems from suns too bright for half floats: at least their
/// maximum, and the maximum of the map.
float brightest_of(const std::vector<Rgb>& map) {
  constexpr float largest_half = 65504.0F;
  float brightest = largest_half;
  for (const Rgb& texel : map) {
    for (int channel = 0; channel < 3; ++channel) {
      if (std::isfinite(texel[channel])) {
        brightest = std::max(brightest, texel[channel]);
      }
    }
  }
  return brightest;
}

struct Repairs {
  std::size_t darkened = 0;  ///< pixels with a negative value or NaN
  std::size_t limited = 0;   ///< with infinity
};

Repairs repair(std::vector<Rgb>& map, float brightest) {
  Repairs repairs;
  for (Rgb& texel : map) {
    bool is_no_light = false;
    bool is_infinite = false;
    for (int channel = 0; channel < 3; ++channel) {
      const float value = texel[channel];
      is_no_light = is_no_light || !(value >= 0.0F);
      is_infinite = is_infinite || value > brightest;
      texel[channel] = value >= 0.0F ? std::min(value, brightest) : 0.0F;
    }
    repairs.darkened += is_no_light ? 1 : 0;
    repairs.limited += is_infinite ? 1 : 0;
  }
  return repairs;
}

void repair(Environment& environment, const std::string& file, Warnings& warnings) {
  const float brightest = brightest_of(environment.map);
  const Repairs repairs = repair(environment.map, brightest);
  if (repairs.darkened > 0) {
    warnings.add(fmt::format("negative or NaN pixels of the environment are black ({} in {})",
                             repairs.darkened, file));
  }
  if (repairs.limited > 0) {
    warnings.add(fmt::format("infinite pixels of the environment are limited to {} ({} in {})",
                             brightest, repairs.limited, file));
  }
}

}  // namespace

Environment load_environment(const std::filesystem::path& path, Warnings& warnings) {
  const std::string bytes = read_file(path);
  try {
    const std::string file = path.filename().string();
    Environment environment = decode(
        {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, file, warnings);
    warn_of_other_projections(environment, file, warnings);
    repair(environment, file, warnings);
    return environment;
  } catch (const std::runtime_error& fault) {
    throw Error(path.string(), fault.what(), "use a whole image, best an EXR or HDR");
  }
}

}  // namespace foveola
