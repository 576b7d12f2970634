// Equivalence: whether a difference is too small to matter.
#pragma once

#include <optional>
#include <span>

#include "analysis/statistics/crossed_model.h"
#include "analysis/statistics/paired_t.h"

namespace foveola::analysis {

/// Two one-sided tests (Schuirmann 1987).
struct EquivalenceTest {
  double p_above_low = 0.0;   ///< P of the hypothesis that the mean is at or below -margin.
  double p_below_high = 0.0;  ///< P of the hypothesis that the mean is at or above +margin.
  double p = 0.0;             ///< The larger P: below alpha, the mean lies within the margins.
  /// The mean's interval with confidence 1 - 2 alpha, which lies within the margins iff p < alpha.
  Interval interval;
};

/// Tests whether the mean of values lies within -margin ... margin; margin above zero, alpha in
/// (0, 0.5). The ratios of times are tested by their logarithms and that of the margin. Empty where
/// one_sample_t is.
std::optional<EquivalenceTest> equivalence(std::span<const double> values, double margin,
                                           double alpha = 0.05);

/// Tests whether the crossed model's mean lies within -margin ... margin. Empty where the model has
/// no test.
std::optional<EquivalenceTest> equivalence(const CrossedModel& model, double margin,
                                           double alpha = 0.05);

}  // namespace foveola::analysis
