#include "renderer/window/pyramid_atlas.h"

#include <algorithm>
#include <cassert>

#include "renderer/film/film_tile.h"

namespace foveola {

PyramidAtlas::PyramidAtlas(int width, int height) {
  assert(width > 0 && height > 0);
  IVec2 size(width, height);
  levels_.push_back({.origin = IVec2(0), .size = size});
  size_ = size;
  int right = 0;
  while (size != IVec2(1) || levels_.size() <= FilmTile::levels) {
    size = (size + 1) / 2;
    levels_.push_back({.origin = IVec2(right, height), .size = size});
    right += size.x;
    size_ = glm::max(size_, IVec2(right, height + size.y));
  }
}

}  // namespace foveola
