#include "analysis/statistics/paired_t.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "analysis/statistics/correlation.h"
#include "analysis/statistics/distributions.h"
#include "analysis/statistics/logarithms.h"
#include "analysis/statistics/rank_tests.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

/// Returns the one-sided P that values shifted by `margin` are centred above zero; `sign` -1
/// mirrors the values.
double p_of_shifted(std::span<const double> values, double sign, double margin) {
  std::vector<double> shifted =
      transformed(values, [&](const double value) { return sign * value + margin; });
  const std::optional<SignedRankTest> test = signed_rank(without_rounding(std::move(shifted)));
  return test ? test->p_above : 1.0;
}

}  // namespace

std::optional<TTest> test_mean(std::span<const double> values, double hypothesis,
                               double confidence) {
  const std::optional<Estimate> estimate = mean_estimate(values, confidence);
  if (!estimate || !estimate->interval) {
    return std::nullopt;
  }
  const double deviation = *standard_deviation(values);
  TTest test;
  test.n = values.size();
  test.mean = estimate->value;
  test.standard_deviation = deviation;
  test.interval = *estimate->interval;
  test.d_z = (test.mean - hypothesis) / deviation;
  test.t = test.d_z * std::sqrt(static_cast<double>(test.n));
  test.degrees_of_freedom = static_cast<double>(test.n) - 1.0;
  test.p = student_t_two_sided(test.t, test.degrees_of_freedom);
  return test;
}

std::optional<RatioTest> test_ratio(std::span<const double> log_ratios, double confidence) {
  const std::optional<TTest> logs = test_mean(log_ratios, 0.0, confidence);
  if (!logs || logs->standard_deviation <= rounding_of_logarithms) {
    return std::nullopt;
  }
  return RatioTest{*logs, std::exp(logs->mean), exp_of(logs->interval)};
}

EquivalenceTest test_equivalence(double estimate, double standard_error, double degrees_of_freedom,
                                 double margin, double alpha) {
  assert(margin > 0.0 && alpha > 0.0 && alpha < 0.5);
  EquivalenceTest result;
  result.p_above_low =
      student_t_one_sided((estimate + margin) / standard_error, degrees_of_freedom);
  result.p_below_high =
      student_t_one_sided((margin - estimate) / standard_error, degrees_of_freedom);
  result.p = std::max(result.p_above_low, result.p_below_high);
  const double half_width =
      student_t_quantile(1.0 - 2.0 * alpha, degrees_of_freedom) * standard_error;
  result.interval = {estimate - half_width, estimate + half_width};
  return result;
}

std::optional<EquivalenceTest> test_equivalence_by_ranks(std::span<const double> values,
                                                         double margin, double alpha) {
  assert(margin > 0.0 && alpha > 0.0 && alpha < 0.5);
  if (values.empty()) {
    return std::nullopt;
  }
  EquivalenceTest result;
  result.p_above_low = p_of_shifted(values, 1.0, margin);
  result.p_below_high = p_of_shifted(values, -1.0, margin);
  result.p = std::max(result.p_above_low, result.p_below_high);
  result.interval = pseudo_median(values, 1.0 - 2.0 * alpha)->interval;
  return result;
}

}  // namespace foveola::analysis
