// A density on the unit square that is constant on each of 8 x 8 squares.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "renderer/base/unit_interval.h"
#include "renderer/base/vec.h"

namespace foveola {

/// Unlike PiecewiseConstant2D it holds no memory elsewhere, since there is one for every region.
class SquareWarp {
 public:
  static constexpr std::size_t width = 8;
  static constexpr std::size_t squares = width * width;

  /// The square that holds a point of the unit square, row by row.
  static std::size_t square_of(const Vec2& point) { return width * step(point.y) + step(point.x); }

  /// weights: of each square, positive and finite.
  explicit SquareWarp(const std::array<double, squares>& weights) {
    double total = 0.0;
    std::array<double, width> rows{};
    for (std::size_t i = 0; i < squares; ++i) {
      total += weights[i];
      rows[i / width] += weights[i];
    }
    double above = 0.0;
    for (std::size_t row = 0; row < width; ++row) {
      double left = 0.0;
      for (std::size_t column = 0; column < width; ++column) {
        const double weight = weights[row * width + column];
        left += weight;
        columns_[row][column] = static_cast<float>(left / rows[row]);
        density_[row][column] = static_cast<float>(weight / total * squares);
      }
      above += rows[row];
      rows_[row] = static_cast<float>(above / total);
    }
  }

  struct Point {
    Vec2 place;  ///< in the unit square
    float density;
  };
  /// u: in the unit square. Neighbouring u give neighbouring points.
  Point sample(const Vec2& u) const {
    const Step row = find(rows_, u.y);
    const Step column = find(columns_[row.index], u.x);
    constexpr float side = 1.0F / static_cast<float>(width);
    const auto place = [](const Step& step) {
      return std::min((static_cast<float>(step.index) + step.within) * side, largest_below_one);
    };
    return {.place = {place(column), place(row)}, .density = density_[row.index][column.index]};
  }

  /// square: see square_of().
  float density_in(std::size_t square) const { return density_[square / width][square % width]; }
  float density(const Vec2& point) const { return density_[step(point.y)][step(point.x)]; }

 private:
  using Sums = std::array<float, width>;
  struct Step {
    std::size_t index;
    float within;  ///< in [0, 1)
  };

  static std::size_t step(float x) {
    return std::min(static_cast<std::size_t>(x * static_cast<float>(width)), width - 1);
  }
  static Step find(const Sums& sums, float u) {
    std::size_t index = 0;
    for (std::size_t i = 0; i + 1 < width; ++i) {
      index += sums[i] <= u ? 1 : 0;
    }
    const float lower = index == 0 ? 0.0F : sums[index - 1];
    return {index, std::clamp((u - lower) / (sums[index] - lower), 0.0F, largest_below_one)};
  }

  Sums rows_{};
  std::array<Sums, width> columns_{};
  std::array<Sums, width> density_{};
};

}  // namespace foveola
