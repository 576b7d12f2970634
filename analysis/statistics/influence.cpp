#include "analysis/statistics/influence.h"

#include <vector>

namespace foveola::analysis {

std::optional<LeaveOneOut> leave_one_out(
    std::span<const double> values,
    const std::function<double(std::span<const double>)>& estimate) {
  if (values.size() < 2) {
    return std::nullopt;
  }
  // The first value is left out first; then each takes the place of the next.
  std::vector<double> others(values.begin() + 1, values.end());
  const double first = estimate(others);
  LeaveOneOut range{.estimates = {first, first}};
  for (std::size_t i = 1; i < values.size(); ++i) {
    others[i - 1] = values[i - 1];
    const double without = estimate(others);
    if (without < range.estimates.low) {
      range.estimates.low = without;
      range.without_low = i;
    }
    if (without > range.estimates.high) {
      range.estimates.high = without;
      range.without_high = i;
    }
  }
  return range;
}

}  // namespace foveola::analysis
