#include "renderer/view/weight_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/image/image_file.h"

namespace foveola {
namespace {

constexpr std::int64_t max_pixels = std::int64_t{64} << 20;

/// Checked before the pixels are read: a header can announce more than fit in memory.
void require_moderate_size(const std::filesystem::path& path) {
  const IVec2 size = image_size(path);
  if (std::int64_t{size.x} * size.y > max_pixels) {
    throw Error(path.string(), fmt::format("{} x {} pixels are too many weights", size.x, size.y),
                fmt::format("scale it down to at most {} million pixels", max_pixels >> 20));
  }
}

}  // namespace

WeightImage read_weights(const std::filesystem::path& path) {
  require_moderate_size(path);
  const RgbImage color = read_film_image(path).color;
  WeightImage image{.width = color.width, .height = color.height, .weights = {}};
  image.weights.resize(color.pixels.size());
  std::transform(color.pixels.begin(), color.pixels.end(), image.weights.begin(),
                 [](const Rgb& pixel) { return luminance(pixel); });
  const auto bad =
      std::ranges::find_if(image.weights, [](float w) { return !(w >= 0.0F && std::isfinite(w)); });
  if (bad != image.weights.end()) {
    const std::ptrdiff_t pixel = bad - image.weights.begin();
    throw Error(path.string(),
                fmt::format("pixel ({}, {}) has the luminance {}", pixel % image.width,
                            pixel / image.width, *bad),
                "make every pixel a number that is not negative");
  }
  if (*std::ranges::max_element(image.weights) == 0.0F) {
    throw Error(path.string(), "is black all over, so no sample could fall anywhere",
                "paint important parts in lighter colours");
  }
  return image;
}

}  // namespace foveola
