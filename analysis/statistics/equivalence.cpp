#include "analysis/statistics/equivalence.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/statistics/student_t.h"

namespace foveola::analysis {

std::optional<EquivalenceTest> equivalence(std::span<const double> values, double margin,
                                           double alpha) {
  assert(margin > 0.0 && alpha > 0.0 && alpha < 0.5);
  const std::optional<TTest> test = one_sample_t(values, 0.0, 1.0 - 2.0 * alpha);
  if (!test) {
    return std::nullopt;
  }
  const double error = test->standard_deviation / std::sqrt(static_cast<double>(test->n));
  EquivalenceTest result;
  result.p_above_low = student_t_one_sided((test->mean + margin) / error, test->degrees_of_freedom);
  result.p_below_high =
      student_t_one_sided((margin - test->mean) / error, test->degrees_of_freedom);
  result.p = std::max(result.p_above_low, result.p_below_high);
  result.interval = test->interval;
  return result;
}

}  // namespace foveola::analysis
