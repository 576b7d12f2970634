#include "study/protocol/scaled_protocol.h"

#include <cmath>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola::study {
namespace {

constexpr int min_pixels_aside = 8;

int scaled_side(int side, double scale) {
  const int scaled = static_cast<int>(std::lround(side / std::sqrt(scale)));
  if (scaled < min_pixels_aside) {
    throw UsageError("--scale", fmt::format("leaves {} pixels of {}; the minimum is {}", scaled,
                                            side, min_pixels_aside));
  }
  return scaled;
}

double pixels_of(const FilmSettings& film) {
  return static_cast<double>(film.width) * static_cast<double>(film.height);
}

void scale_film(FilmSettings& film, double scale) {
  // Pixels of 9 degrees each: hardly an object is as large, and none has an outline.
  constexpr double min_pixels = 500.0;
  const std::string full = fmt::format("{} x {}", film.width, film.height);
  film.width = scaled_side(film.width, scale);
  film.height = scaled_side(film.height, scale);
  if (pixels_of(film) < min_pixels) {
    throw UsageError(
        "--scale",
        fmt::format("leaves a film of {} x {} pixels of one of {}, on which nothing "
                    "can be recognised; choose a scale that leaves {:.0f} pixels or more",
                    film.width, film.height, full, min_pixels));
  }
}

}  // namespace

Protocol scaled_protocol(Protocol protocol, double scale) {
  if (!std::isfinite(scale) || scale < 1.0) {
    throw UsageError("--scale", "must be at least 1");
  }
  if (scale == 1.0) {
    return protocol;
  }
  const double pixels = pixels_of(protocol.film);
  scale_film(protocol.film, scale);
  for (auto& [place, cell] : protocol.cells) {
    scale_film(cell.film, scale);
  }
  protocol.display.view_width = scaled_side(protocol.display.view_width, scale);
  protocol.display.view_height = scaled_side(protocol.display.view_height, scale);
  protocol.machine.samples_per_second *= pixels_of(protocol.film) / pixels;
  return protocol;
}

}  // namespace foveola::study
