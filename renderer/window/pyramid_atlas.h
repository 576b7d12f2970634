// The levels of a film's pyramid side by side in one image, as the graphics card keeps them, and
// the changes that bring it up to date.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/film/premultiplied_texel.h"

namespace foveola {

/// Level 0 stands at the top left; the others stand in a row below it, in their order.
class PyramidAtlas {
 public:
  struct Level {
    IVec2 origin{0};  ///< where its cell (0, 0) lies
    IVec2 size{0};    ///< cells
  };

  PyramidAtlas() = default;
  /// The atlas of a film of width x height pixels: as many levels as it has, the last a single
  /// cell.
  PyramidAtlas(int width, int height);

  const IVec2& size() const { return size_; }
  const std::vector<Level>& levels() const { return levels_; }

 private:
  IVec2 size_{0};
  std::vector<Level> levels_;
};

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
