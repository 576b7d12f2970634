#include "analysis/statistics/paired_t.h"

#include <cmath>

#include "analysis/statistics/logarithms.h"
#include "analysis/statistics/student_t.h"

namespace foveola::analysis {

std::optional<TTest> one_sample_t(std::span<const double> values, double hypothesis,
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

std::optional<RatioTest> ratio_t(std::span<const double> log_ratios, double confidence) {
  const std::optional<TTest> logs = one_sample_t(log_ratios, 0.0, confidence);
  if (!logs || logs->standard_deviation <= rounding_of_logarithms) {
    return std::nullopt;
  }
  return RatioTest{*logs, std::exp(logs->mean), exp_of(logs->interval)};
}

}  // namespace foveola::analysis
