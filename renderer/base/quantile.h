// The values below which parts of a sample lie.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace foveola {

/// The least of the values that is no less than `share` of them (Hyndman and Fan 1996, "Sample
/// Quantiles in Statistical Packages", definition 1). sorted: ascending, at least one. share: in
/// [0, 1].
inline double quantile(std::span<const double> sorted, double share) {
  assert(!sorted.empty() && share >= 0.0 && share <= 1.0);
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::max(rank, std::size_t{1}) - 1];
}

/// The middle one, of an even number the upper of the two; empty without values.
inline std::optional<double> upper_median(std::vector<double> values) {
  if (values.empty()) {
    return std::nullopt;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace foveola
