#include "renderer/film/texel_pyramid.h"

#include <algorithm>

namespace foveola {

TexelPyramid::TexelPyramid(int width, int height) {
  for (;;) {
    const auto cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    levels_.push_back(
        {width, height, std::vector<PremultipliedTexel>(cells), std::vector<bool>(cells)});
    if (width == 1 && height == 1) {
      return;
    }
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
}

PremultipliedTexel TexelPyramid::mean_below(std::size_t level, int x, int y) const {
  const Level& below = levels_[level - 1];
  return mean_of_square(x, y, below.width, below.height, [&](int column, int row) {
    return below.cells[static_cast<std::size_t>(row * below.width + column)];
  });
}

void TexelPyramid::refresh(std::vector<std::uint32_t> changed) {
  std::vector<std::uint32_t> parents;
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    Level& at = levels_[level];
    const int width_below = levels_[level - 1].width;
    parents.clear();
    for (const std::uint32_t cell : changed) {
      const int x = static_cast<int>(cell) % width_below / 2;
      const int y = static_cast<int>(cell) / width_below / 2;
      const auto parent = static_cast<std::uint32_t>(y * at.width + x);
      if (!at.changed[parent]) {
        at.changed[parent] = true;
        parents.push_back(parent);
        at.cells[parent] = mean_below(level, x, y);
      }
    }
    for (const std::uint32_t parent : parents) {
      at.changed[parent] = false;
    }
    changed.swap(parents);
  }
}

void TexelPyramid::clear(std::span<const std::uint32_t> filled) {
  const auto finest_width = static_cast<std::uint32_t>(width(0));
  std::uint32_t number = 0;
  for (Level& level : levels_) {
    // Contiguous cells are emptied several times faster than scattered ones.
    constexpr std::size_t faster = 4;
    if (level.cells.size() <= faster * filled.size()) {
      std::ranges::fill(level.cells, PremultipliedTexel{});
    } else {
      for (const std::uint32_t cell : filled) {
        const std::size_t x = cell % finest_width >> number;
        const std::size_t y = cell / finest_width >> number;
        level.cells[y * static_cast<std::size_t>(level.width) + x] = {};
      }
    }
    ++number;
  }
}

}  // namespace foveola
