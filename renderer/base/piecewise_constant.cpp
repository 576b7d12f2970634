#include "renderer/base/piecewise_constant.h"

#include <algorithm>
#include <cassert>

#include "renderer/base/unit_interval.h"

namespace foveola {
namespace {

/// Writes the running sums of `weights` over their sum, which is returned.
template <typename Weight>
double accumulate(std::span<const Weight> weights, std::span<float> running) {
  double total = 0.0;
  for (const Weight weight : weights) {
    total += weight;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i];
    running[i] = total > 0.0 ? static_cast<float>(sum / total) : 0.0F;
  }
  return total;
}

float probability_of(std::span<const float> running, std::size_t i) {
  return i == 0 ? running[0] : running[i] - running[i - 1];
}

struct Interval {
  std::size_t index;
  float fraction;  ///< how far through the item, in [0, 1)
};

/// How many of the leading elements are not above u, at most all but the last. Without branches:
/// where u falls cannot be predicted.
std::size_t count_not_above(std::span<const float> running, float u) {
  std::size_t begin = 0;
  for (std::size_t left = running.size(); left > 1;) {
    const std::size_t half = left / 2;
    begin += running[begin + half - 1] <= u ? half : 0;
    left -= half;
  }
  return begin;
}

/// The interval of `running` that holds u; never one of zero width.
Interval find_interval(std::span<const float> running, float u) {
  const std::size_t index = count_not_above(running, u);
  const float lower = index == 0 ? 0.0F : running[index - 1];
  const float width = running[index] - lower;
  const float fraction = width > 0.0F ? (u - lower) / width : 0.5F;
  return {index, std::min(fraction, largest_below_one)};
}

}  // namespace

PiecewiseConstant2D::PiecewiseConstant2D(std::size_t width, std::size_t height,
                                         std::span<const float> weights)
    : width_(width), row_sums_(height), column_sums_(width * height) {
  assert(weights.size() == width * height);
  std::vector<double> row_totals(height);
  for (std::size_t row = 0; row < height; ++row) {
    row_totals[row] = accumulate(weights.subspan(row * width, width),
                                 std::span(column_sums_).subspan(row * width, width));
  }
  total_ = accumulate(std::span<const double>(row_totals), std::span(row_sums_));
}

PiecewiseConstant2D::Point PiecewiseConstant2D::sample(const Vec2& u) const {
  const Interval row = find_interval(row_sums_, u.y);
  const Interval column = find_interval(columns_of(row.index), u.x);
  return {.column = column.index,
          .row = row.index,
          .within = {column.fraction, row.fraction},
          .probability = probability(column.index, row.index)};
}

float PiecewiseConstant2D::probability(std::size_t column, std::size_t row) const {
  return probability_of(row_sums_, row) * probability_of(columns_of(row), column);
}

}  // namespace foveola
