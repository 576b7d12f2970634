// The mean in extended precision, on which the other sums of this module rest.
#pragma once

#include <numeric>
#include <span>

namespace foveola::analysis {

/// The mean of a sample that is not empty. The second pass takes out the rounding of the first, and
/// the range of long double keeps sums and squares of the largest doubles finite.
inline long double extended_mean(std::span<const double> values) {
  const auto n = static_cast<long double>(values.size());
  const long double first = std::accumulate(values.begin(), values.end(), 0.0L) / n;
  long double remainder = 0.0L;
  for (const double value : values) {
    remainder += value - first;
  }
  return first + remainder / n;
}

}  // namespace foveola::analysis
