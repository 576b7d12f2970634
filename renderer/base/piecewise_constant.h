// Drawing a cell of a grid, and a point in it, with a density that is constant in each cell.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

class PiecewiseConstant2D {
 public:
  /// weights: row-major, width * height of them, >= 0 and finite. A grid without any weight draws
  /// nothing useful: see total().
  PiecewiseConstant2D(std::size_t width, std::size_t height, std::span<const float> weights);

  /// The sum of the weights.
  double total() const { return total_; }

  struct Point {
    std::size_t column = 0;
    std::size_t row = 0;
    Vec2 within{0.0F};  ///< uniform in the unit square: the place in the cell
    float probability = 0.0F;
  };
  /// u: in the unit square. Neighbouring u give neighbouring points.
  Point sample(const Vec2& u) const;

  /// The probability that sample() draws this cell.
  float probability(std::size_t column, std::size_t row) const;

 private:
  std::span<const float> columns_of(std::size_t row) const {
    return std::span(column_sums_).subspan(row * width_, width_);
  }

  std::size_t width_;
  double total_ = 0.0;
  std::vector<float> row_sums_;     ///< cumulative, normalised: the last is 1
  std::vector<float> column_sums_;  ///< cumulative and normalised within each row
};

}  // namespace foveola
