// Equivalence: whether a difference is too small to matter.
#pragma once

#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// Two one-sided tests (Schuirmann 1987).
struct EquivalenceTest {
  double p_above_low = 0.0;   ///< P of the hypothesis that the effect is at or below -margin.
  double p_below_high = 0.0;  ///< P of the hypothesis that the effect is at or above +margin.
  double p = 0.0;             ///< The larger P: below alpha, the effect lies within the margins.
  /// The effect's interval with confidence 1 - 2 alpha. Empty where ranks of few values have none.
  std::optional<Interval> interval;
};

/// Tests whether an estimated effect lies within -margin ... margin by Student's t; margin,
/// standard error and degrees of freedom above zero, alpha in (0, 0.5). Ratios are tested by their
/// logarithms and that of the margin. The interval lies within the margins if and only if p <
/// alpha.
EquivalenceTest equivalence(double estimate, double standard_error, double degrees_of_freedom,
                            double margin, double alpha = 0.05);

/// The same of the centre of symmetry of the values' distribution, by Wilcoxon's signed-rank test;
/// the interval is Hodges and Lehmann's. Empty without values.
std::optional<EquivalenceTest> equivalence_by_ranks(std::span<const double> values, double margin,
                                                    double alpha = 0.05);

}  // namespace foveola::analysis
