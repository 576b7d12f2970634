#include "analysis/statistics/ranks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foveola::analysis {

std::vector<double> without_rounding(std::vector<double> values) {
  constexpr double step = 1e12;
  for (double& value : values) {
    value = std::round(value * step) / step;
  }
  return values;
}

Ranks rank(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  Ranks result{std::vector<double>(values.size()), 0.0};
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] == values[order[first]]) {
      ++end;
    }
    for (std::size_t i = first; i < end; ++i) {
      result.ranks[order[i]] = (static_cast<double>(first) + static_cast<double>(end) + 1.0) / 2.0;
    }
    const auto ties = static_cast<double>(end - first);
    result.tie_correction += ties * ties * ties - ties;
    first = end;
  }
  return result;
}

}  // namespace foveola::analysis
