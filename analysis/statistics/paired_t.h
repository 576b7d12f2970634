// Student's t test of differences within participants, and tests of equivalence.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

struct TTest {
  std::size_t n = 0;
  double mean = 0.0;                ///< Mean difference.
  double standard_deviation = 0.0;  ///< Standard deviation of the differences, above zero.
  Interval interval;                ///< Interval of the mean difference.
  double t = 0.0;
  double degrees_of_freedom = 0.0;
  double p = 0.0;    ///< Two-sided.
  double d_z = 0.0;  ///< Cohen's (1988) effect size of differences: mean / standard deviation.

  double standard_error() const { return standard_deviation / std::sqrt(static_cast<double>(n)); }
};

/// Tests whether the mean of values is `hypothesis`. confidence: in (0, 1). Empty if t is not
/// defined: the values do not vary (descriptive.h), or are fewer than two.
std::optional<TTest> test_mean(std::span<const double> values, double hypothesis = 0.0,
                               double confidence = default_confidence);

/// A paired t test of ratios, on their logarithms.
struct RatioTest {
  TTest logs;          ///< The test of the logarithms of the ratios.
  double ratio = 0.0;  ///< The geometric mean of the ratios.
  Interval interval;   ///< Interval of `ratio`.
};

/// Tests whether the geometric mean of ratios is 1. confidence: in (0, 1). Empty if
/// geometric_mean_of_logs, which gives the estimate without a test, has no interval.
std::optional<RatioTest> test_ratio(std::span<const double> log_ratios,
                                    double confidence = default_confidence);

/// Two one-sided tests (Schuirmann 1987).
struct EquivalenceTest {
  double p_above_low = 0.0;   ///< P of the hypothesis that the effect is at or below -margin.
  double p_below_high = 0.0;  ///< P of the hypothesis that the effect is at or above +margin.
  double p = 0.0;             ///< The larger P: below alpha, the effect lies within the margins.
  /// The effect's interval with confidence 1 - 2 alpha. Empty if there are too few values for
  /// an interval by ranks.
  std::optional<Interval> interval;
};

/// Tests by Student's t whether an estimated effect lies within -margin ... margin. Margin,
/// standard error and degrees of freedom are above zero, alpha in (0, 0.5). Ratios are tested by
/// their logarithms and that of the margin. The interval lies within the margins if and only if p <
/// alpha.
EquivalenceTest test_equivalence(double estimate, double standard_error, double degrees_of_freedom,
                                 double margin, double alpha = 0.05);

/// Tests the same of the centre of symmetry of the values' distribution, by Wilcoxon's signed-rank
/// test; the interval is Hodges and Lehmann's. Margin and alpha as above. Empty without values.
std::optional<EquivalenceTest> test_equivalence_by_ranks(std::span<const double> values,
                                                         double margin, double alpha = 0.05);

}  // namespace foveola::analysis
