#include "renderer/base/piecewise_constant.h"

#include <algorithm>
#include <cassert>

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
  float fraction;  ///< of the way through it
};

/// The interval of `running` that holds u; never one of zero width.
Interval find_interval(std::span<const float> running, float u) {
  const auto found = std::upper_bound(running.begin(), running.end(), u);
  const auto index = static_cast<std::size_t>(
      std::min(found - running.begin(), static_cast<std::ptrdiff_t>(running.size()) - 1));
  const float lower = index == 0 ? 0.0F : running[index - 1];
  const float width = running[index] - lower;
  const float fraction = width > 0.0F ? (u - lower) / width : 0.5F;
  return {index, std::min(fraction, 0x1.fffffep-1F)};
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
