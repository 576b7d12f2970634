// Pearson's correlation: whether two measures of the same participants go together.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

struct Correlation {
  std::size_t n = 0;
  double r = 0.0;
  double t = 0.0;      ///< r sqrt((n - 2) / (1 - r^2)); infinite for a perfect correlation
  double p = 0.0;      ///< Two-sided, from t with n - 2 degrees of freedom unless it is exact.
  bool exact = false;  ///< Whether p counts all orders of the ranks.
  std::optional<Interval> interval;  ///< Fisher's z transform; needs four pairs
};

/// The interval of a correlation: atanh(r) -+ half_width, transformed back (Fisher's z).
Interval fisher_interval(double r, double half_width);

/// Pearson's product-moment correlation of the pairs (x[i], y[i]), all finite. Empty where it is
/// not defined: fewer than three pairs, or x or y constant.
std::optional<Correlation> pearson(std::span<const double> x, std::span<const double> y,
                                   double confidence = default_confidence);

}  // namespace foveola::analysis
