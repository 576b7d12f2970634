#include "renderer/commands/picture_faults.h"

#include <cstddef>

#include <fmt/format.h>

#include "renderer/image/tone_mapping.h"

namespace foveola {
namespace {

constexpr double nearly_all = 0.98;
constexpr double mostly = 0.9;
/// Half of the first of 255 steps of the sRGB transfer function.
constexpr float black = 0.5F / 255.0F / 12.92F;

struct Shares {
  double black = 0.0;
  double white = 0.0;
};

Shares shares_of(const FilmImage& image, float scale) {
  std::size_t sampled = 0;
  std::size_t blacks = 0;
  std::size_t whites = 0;
  for (std::size_t i = 0; i < image.color.pixels.size(); ++i) {
    if (image.samples.empty() || image.samples[i] > 0) {
      const Rgb shown = scale * image.color.pixels[i];
      ++sampled;
      blacks += max_component(shown) < black ? 1 : 0;
      whites += glm::all(glm::greaterThanEqual(shown, Rgb(1.0F))) ? 1 : 0;
    }
  }
  if (sampled == 0) {
    return {};
  }
  const auto all = static_cast<double>(sampled);
  return {.black = static_cast<double>(blacks) / all, .white = static_cast<double>(whites) / all};
}

int percent(double share) { return static_cast<int>(100.0 * share); }

}  // namespace

std::vector<std::string> picture_faults(const FilmImage& image, double exposure_stops,
                                        bool is_enclosed) {
  const Shares shares = shares_of(image, exposure_scale(exposure_stops));
  if (shares.black >= nearly_all) {
    return {fmt::format(
        "{} % of the picture is black: --exposure auto or a higher number brightens it, {}, and "
        "--camera looks from elsewhere",
        percent(shares.black),
        is_enclosed ? "the scene, which is closed around the camera, needs lights within"
                    : "--environment 1,1,1 lights the scene evenly")};
  }
  if (shares.white >= mostly) {
    return {fmt::format(
        "{} % of the picture is white: --exposure auto or a lower number darkens it; if the file's "
        "lights are in lux and candela, --light-units photometric brings them to watts",
        percent(shares.white))};
  }
  return {};
}

}  // namespace foveola
