// Equivalence: whether a difference is too small to matter.
#pragma once

#include <optional>
#include <span>

#include "analysis/statistics/paired_t.h"

namespace foveola::analysis {

/// Two one-sided tests (Schuirmann 1987).
struct EquivalenceTest {
  double p_above_low = 0.0;   ///< of the hypothesis that the mean is at or below -margin
  double p_below_high = 0.0;  ///< of the hypothesis that the mean is at or above +margin
  double p = 0.0;             ///< the larger one: below alpha, the mean lies within the margins
  Interval interval;          ///< of the mean, with confidence 1 - 2 alpha: within iff p < alpha
};

/// Whether the mean of values lies within -margin ... margin; margin above zero, alpha in (0, 0.5).
/// Empty as one_sample_t is.
std::optional<EquivalenceTest> equivalence(std::span<const double> values, double margin,
                                           double alpha = 0.05);

/// The same of ratios a[i] / b[i]: whether their geometric mean lies within 1 / margin ... margin,
/// margin above 1. The interval is of the ratio. Throws Error as logarithms does.
std::optional<EquivalenceTest> ratio_equivalence(std::span<const double> a,
                                                 std::span<const double> b, double margin,
                                                 double alpha = 0.05);

}  // namespace foveola::analysis
