// The levels of a film's pyramid side by side in one image, as the graphics card keeps them.
#pragma once

#include <vector>

#include "renderer/base/vec.h"

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

}  // namespace foveola
