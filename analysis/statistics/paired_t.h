// Student's t test of differences within participants, in plain units or as ratios.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

struct TTest {
  std::size_t n = 0;
  double mean = 0.0;                ///< of the differences
  double standard_deviation = 0.0;  ///< of the differences, above zero
  Interval interval;                ///< of the mean
  double t = 0.0;
  double degrees_of_freedom = 0.0;
  double p = 0.0;    ///< two-sided
  double d_z = 0.0;  ///< Cohen's (1988) effect size of differences: mean / standard deviation
};

/// Whether the mean of values is `hypothesis`. Empty where t is not defined: fewer than two values,
/// or all alike.
std::optional<TTest> one_sample_t(std::span<const double> values, double hypothesis = 0.0,
                                  double confidence = default_confidence);

/// The same of the differences a[i] - b[i], whose mean is zero by the hypothesis.
std::optional<TTest> paired_t(std::span<const double> a, std::span<const double> b,
                              double confidence = default_confidence);

/// A paired t test on logarithms: of ratios a[i] / b[i].
struct RatioTest {
  TTest logs;          ///< of the logarithms of the ratios
  double ratio = 0.0;  ///< the geometric mean of the ratios
  Interval interval;   ///< of `ratio`
};

/// Throws Error as logarithms does. Empty as paired_t.
std::optional<RatioTest> paired_ratio_t(std::span<const double> a, std::span<const double> b,
                                        double confidence = default_confidence);

}  // namespace foveola::analysis
