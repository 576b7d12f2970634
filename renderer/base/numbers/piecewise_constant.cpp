#include "renderer/base/numbers/piecewise_constant.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

/// Writes the cumulative sums of `weights` divided by their sum, which is returned.
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

/// Number of the leading elements that are not above u, of those before the last. Without branches:
/// the place of u cannot be predicted.
std::size_t count_not_above(std::span<const float> running, float u) {
  std::size_t begin = 0;
  for (std::size_t left = running.size(); left > 1;) {
    const std::size_t half = left / 2;
    begin += running[begin + half - 1] <= u ? half : 0;
    left -= half;
  }
  return begin;
}

/// Number of sums per step: a guide then takes a quarter of their memory.
constexpr std::size_t sums_per_step = 4;

}  // namespace

PiecewiseConstant2D::Rows::Rows(std::size_t rows, std::size_t size)
    : size_(size),
      steps_(std::bit_floor(std::max(size / sums_per_step, std::size_t{1}))),
      sums_(rows * size),
      guides_(rows * (steps_ + 1)) {}

void PiecewiseConstant2D::Rows::guide(std::size_t row) {
  const std::span<const float> running = sums(row);
  std::size_t not_above = 0;
  for (std::size_t step = 0; step <= steps_; ++step) {
    const float border = static_cast<float>(step) / static_cast<float>(steps_);
    while (not_above + 1 < size_ && running[not_above] <= border) {
      ++not_above;
    }
    guides_[row * (steps_ + 1) + step] = static_cast<std::uint32_t>(not_above);
  }
}

std::size_t PiecewiseConstant2D::Rows::count_not_above(std::size_t row, float u) const {
  const auto step = std::min(static_cast<std::size_t>(u * static_cast<float>(steps_)), steps_ - 1);
  const std::uint32_t* guide = &guides_[row * (steps_ + 1) + step];
  return guide[0] +
         foveola::count_not_above(sums(row).subspan(guide[0], guide[1] - guide[0] + 1), u);
}

PiecewiseConstant2D::PiecewiseConstant2D(std::size_t width, std::size_t height,
                                         std::span<const float> weights)
    : row_(1, height), columns_(height, width) {
  assert(weights.size() == width * height);
  std::vector<double> row_totals(height);
  for (std::size_t row = 0; row < height; ++row) {
    row_totals[row] = accumulate(weights.subspan(row * width, width), columns_.sums(row));
    columns_.guide(row);
  }
  total_ = accumulate(std::span<const double>(row_totals), row_.sums(0));
  row_.guide(0);
}

PiecewiseConstant2D::Interval PiecewiseConstant2D::find_interval(const Rows& rows, std::size_t row,
                                                                 float u) {
  const std::span<const float> sums = rows.sums(row);
  const std::size_t index = rows.count_not_above(row, u);
  const float lower = index == 0 ? 0.0F : sums[index - 1];
  const float width = sums[index] - lower;
  const float fraction = width > 0.0F ? (u - lower) / width : 0.5F;
  return {index, std::min(fraction, largest_below_one)};
}

PiecewiseConstant2D::Point PiecewiseConstant2D::sample(const Vec2& u) const {
  const Interval row = find_interval(row_, 0, u.y);
  const Interval column = find_interval(columns_, row.index, u.x);
  return {.column = column.index,
          .row = row.index,
          .within = {column.fraction, row.fraction},
          .probability = probability(column.index, row.index)};
}

Vec2 PiecewiseConstant2D::place_of(const Point& point) const {
  const auto place = [](std::span<const float> sums, std::size_t index, float within) {
    const float lower = index == 0 ? 0.0F : sums[index - 1];
    return lower + within * (sums[index] - lower);
  };
  return {place(columns_.sums(point.row), point.column, point.within.x),
          place(row_.sums(0), point.row, point.within.y)};
}

float PiecewiseConstant2D::probability(std::size_t column, std::size_t row) const {
  return probability_of(row_.sums(0), row) * probability_of(columns_.sums(row), column);
}

}  // namespace foveola
