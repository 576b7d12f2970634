// A pyramid of averages.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/film/premultiplied_texel.h"

namespace foveola {

/// Levels of cells, each of which averages four of the level below.
class TexelPyramid {
 public:
  /// The finest level, number 0, is width x height cells, both positive; the last is a single cell.
  TexelPyramid(int width, int height);

  int count() const { return static_cast<int>(levels_.size()); }
  int width(int level) const { return levels_[static_cast<std::size_t>(level)].width; }
  int height(int level) const { return levels_[static_cast<std::size_t>(level)].height; }
  const PremultipliedTexel& cell(int level, int x, int y) const {
    const Level& at = levels_[static_cast<std::size_t>(level)];
    return at.cells[static_cast<std::size_t>(y * at.width + x)];
  }
  /// The finest level's cells, row by row; different cells may be written at the same time.
  PremultipliedTexel& finest(std::uint32_t index) { return levels_.front().cells[index]; }

  /// Averages anew what lies above these cells of the finest level.
  void refresh(std::vector<std::uint32_t> changed);
  /// Empties these cells of the finest level, and what lies above them.
  void clear(std::span<const std::uint32_t> filled);

 private:
  struct Level {
    int width;
    int height;
    std::vector<PremultipliedTexel> cells;
    std::vector<bool> changed;  ///< all false between calls
  };

  PremultipliedTexel mean_below(std::size_t level, int x, int y) const;

  std::vector<Level> levels_;
};

}  // namespace foveola
