#include "analysis/statistics/equivalence.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/statistics/student_t.h"

namespace foveola::analysis {
namespace {

EquivalenceTest test_within(double mean, double standard_error, double degrees_of_freedom,
                            double margin, double alpha) {
  assert(margin > 0.0 && alpha > 0.0 && alpha < 0.5);
  EquivalenceTest result;
  result.p_above_low = student_t_one_sided((mean + margin) / standard_error, degrees_of_freedom);
  result.p_below_high = student_t_one_sided((margin - mean) / standard_error, degrees_of_freedom);
  result.p = std::max(result.p_above_low, result.p_below_high);
  const double half_width =
      student_t_quantile(1.0 - 2.0 * alpha, degrees_of_freedom) * standard_error;
  result.interval = {mean - half_width, mean + half_width};
  return result;
}

}  // namespace

std::optional<EquivalenceTest> equivalence(std::span<const double> values, double margin,
                                           double alpha) {
  const std::optional<TTest> test = one_sample_t(values);
  if (!test) {
    return std::nullopt;
  }
  const double error = test->standard_deviation / std::sqrt(static_cast<double>(test->n));
  return test_within(test->mean, error, test->degrees_of_freedom, margin, alpha);
}

std::optional<EquivalenceTest> equivalence(const CrossedModel& model, double margin, double alpha) {
  if (!model.test) {
    return std::nullopt;
  }
  return test_within(model.mean, model.test->standard_error, model.test->degrees_of_freedom, margin,
                     alpha);
}

}  // namespace foveola::analysis
