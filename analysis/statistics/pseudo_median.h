// Hodges and Lehmann's estimate: how large a difference is, beside what Wilcoxon's test says of it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

struct PseudoMedian {
  std::size_t n = 0;
  double value = 0.0;  ///< The median of all Walsh averages (x[i] + x[j]) / 2 with i <= j.
  /// Two Walsh averages that cover the population's value with at least the confidence asked
  /// (Hollander and Wolfe 1973, 3.4): the inversion of the signed-rank test, by its exact
  /// distribution without ties up to largest_exact_signed_rank values, by the normal approximation
  /// above. Conservative where there are ties. Empty where there is no such interval: at 95 %, with
  /// fewer than six values.
  std::optional<Interval> interval;
};

/// All values are finite; zeros count like any other. Takes O(n log n): the averages are never
/// listed. Empty without values.
std::optional<PseudoMedian> pseudo_median(std::span<const double> values,
                                          double confidence = default_confidence);

}  // namespace foveola::analysis
