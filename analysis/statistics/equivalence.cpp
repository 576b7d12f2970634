#include "analysis/statistics/equivalence.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "analysis/statistics/logarithms.h"
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

std::optional<EquivalenceTest> ratio_equivalence(std::span<const double> a,
                                                 std::span<const double> b, double margin,
                                                 double alpha) {
  assert(a.size() == b.size() && margin > 1.0);
  std::vector<double> differences = logarithms(a);
  const std::vector<double> reference = logarithms(b);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    differences[i] -= reference[i];
  }
  std::optional<EquivalenceTest> result = equivalence(differences, std::log(margin), alpha);
  if (result) {
    result->interval = {std::exp(result->interval.low), std::exp(result->interval.high)};
  }
  return result;
}

}  // namespace foveola::analysis
