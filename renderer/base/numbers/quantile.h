// Quantiles and medians of a sample.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

namespace foveola {

/// The smallest value with at least `share` of the values at or below it (Hyndman and Fan 1996,
/// "Sample Quantiles in Statistical Packages", definition 1). sorted: ascending, at least one.
/// share: in [0, 1].
inline double quantile(std::span<const double> sorted, double share) {
  assert(!sorted.empty() && share >= 0.0 && share <= 1.0);
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::max(rank, std::size_t{1}) - 1];
}

/// The middle value, the upper one of two; nullopt without values.
inline std::optional<double> upper_median(std::vector<double> values) {
  if (values.empty()) {
    return std::nullopt;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The middle value, or the mean of the middle two; nullopt without values.
inline std::optional<double> median(std::span<const double> values) {
  std::vector<double> ordered(values.begin(), values.end());
  const std::optional<double> upper = upper_median(ordered);
  if (ordered.size() % 2 == 1 || !upper) {
    return upper;
  }
  const auto lower = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2 - 1);
  std::nth_element(ordered.begin(), lower, ordered.end());
  return std::midpoint(*lower, *upper);
}

}  // namespace foveola
