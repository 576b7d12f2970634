// The changes that bring a copy of the film's pyramid up to date.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/film/premultiplied_texel.h"

namespace foveola {

/// Gives all cells of a rectangle of the atlas one value.
struct AtlasRectangle {
  std::uint16_t x = 0;  ///< column of its top left cell
  std::uint16_t y = 0;
  std::uint16_t width = 1;  ///< cells
  std::uint16_t height = 1;
  PremultipliedTexel value;
};

/// In order: later rectangles lie over earlier ones.
using FilmUpdate = std::vector<AtlasRectangle>;

}  // namespace foveola
