// A pyramid of averages of pixels that may lack samples.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

/// A square of pixels, where pixels without samples count as black and weightless: the sum of the
/// colours over the number of all pixels, and the fraction with samples. Their quotient is the mean
/// of the sampled pixels, so that an unsampled pixel neither darkens nor brightens its neighbours.
struct PremultipliedTexel {
  Rgb color{0.0F};
  float weight = 0.0F;

  PremultipliedTexel& operator+=(const PremultipliedTexel& other) {
    color += other.color;
    weight += other.weight;
    return *this;
  }
};

inline PremultipliedTexel operator*(float factor, const PremultipliedTexel& texel) {
  return {factor * texel.color, factor * texel.weight};
}

/// The texel of the square of four equal ones.
inline PremultipliedTexel mean_of(const PremultipliedTexel& a, const PremultipliedTexel& b,
                                  const PremultipliedTexel& c, const PremultipliedTexel& d) {
  return {0.25F * ((a.color + b.color) + (c.color + d.color)),
          0.25F * ((a.weight + b.weight) + (c.weight + d.weight))};
}

/// The texel of the square at (x, y) one level up from width x height cells, given by cell(x, y);
/// cells beyond them are empty.
template <typename Cell>
PremultipliedTexel mean_of_square(int x, int y, int width, int height, const Cell& cell) {
  const auto known = [&](int column, int row) -> PremultipliedTexel {
    return column < width && row < height ? cell(column, row) : PremultipliedTexel{};
  };
  return mean_of(known(2 * x, 2 * y), known(2 * x + 1, 2 * y), known(2 * x, 2 * y + 1),
                 known(2 * x + 1, 2 * y + 1));
}

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
  /// The finest level's cells, row by row; different cells may be written concurrently.
  PremultipliedTexel& finest(std::uint32_t index) { return levels_.front().cells[index]; }

  /// Updates the averages above these cells of the finest level.
  void refresh(std::vector<std::uint32_t> changed);
  /// Empties these cells of the finest level, and updates the averages above.
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
