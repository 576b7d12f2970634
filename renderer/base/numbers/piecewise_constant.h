// Samples a grid with a density that is constant in each cell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

class PiecewiseConstant2D {
 public:
  /// weights: row-major, width * height of them, >= 0 and finite. If total() is 0, samples are
  /// meaningless.
  PiecewiseConstant2D(std::size_t width, std::size_t height, std::span<const float> weights);

  /// The sum of the weights.
  double total() const { return total_; }

  struct Point {
    std::size_t column = 0;
    std::size_t row = 0;
    Vec2 within{0.0F};  ///< uniform in the unit square: position in the cell
    float probability = 0.0F;
  };
  /// u: in the unit square. Neighbouring u give neighbouring points.
  Point sample(const Vec2& u) const;

  /// The inverse of sample(): the u of a point, whose probability need not be set. Undefined in
  /// cells of probability 0.
  Vec2 place_of(const Point& point) const;

  /// The probability that sample() chooses this cell.
  float probability(std::size_t column, std::size_t row) const;

 private:
  /// Rows of equal numbers of normalised cumulative weights (the last of a row is 1), with a guide
  /// table. Without the guide most steps of a search would wait for memory.
  class Rows {
   public:
    Rows(std::size_t rows, std::size_t size);

    std::span<float> sums(std::size_t row) { return std::span(sums_).subspan(row * size_, size_); }
    std::span<const float> sums(std::size_t row) const {
      return std::span(sums_).subspan(row * size_, size_);
    }
    /// Builds the guide of a row. To be called once the row's sums are complete.
    void guide(std::size_t row);

    /// Number of the row's leading sums that are <= u, at most all but the last. u in [0, 1].
    std::size_t count_not_above(std::size_t row, float u) const;

   private:
    std::size_t size_;
    std::size_t steps_;  ///< number of steps that divide [0, 1); a power of two
    std::vector<float> sums_;
    std::vector<std::uint32_t> guides_;  ///< per row, the counts at the steps' borders
  };
  struct Interval {
    std::size_t index;
    float fraction;  ///< position in the item, in [0, 1)
  };
  /// The interval of the row that holds u; never one of zero width.
  static Interval find_interval(const Rows& rows, std::size_t row, float u);

  double total_ = 0.0;
  Rows row_;      ///< a single row: the grid's row sums
  Rows columns_;  ///< one per row of the grid
};

}  // namespace foveola
