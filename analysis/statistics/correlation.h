// Correlations: Pearson's, and Spearman's of ranks with ties.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

struct Correlation {
  std::size_t n = 0;
  double r = 0.0;
  double t = 0.0;      ///< r sqrt((n - 2) / (1 - r^2)); infinite for a perfect correlation
  double p = 0.0;      ///< Two-sided, from t with n - 2 degrees of freedom unless it is exact.
  bool exact = false;  ///< Whether p counts all orders of the ranks.
  std::optional<Interval> interval;  ///< By Fisher's z transform; needs four pairs
};

/// Returns the interval of a correlation: atanh(r) -+ half_width, transformed back (Fisher's z).
Interval fisher_interval(double r, double half_width);

/// Returns Pearson's product-moment correlation of the pairs (x[i], y[i]), all finite. Empty if it
/// is not defined: fewer than three pairs, or x or y constant.
std::optional<Correlation> pearson(std::span<const double> x, std::span<const double> y,
                                   double confidence = default_confidence);

/// Maximum number of pairs for an exact P-value, with or without ties: twice the share of all
/// orders of y whose correlation is at least as far on the same side (as R's cor.test, which
/// refuses ties).
inline constexpr std::size_t largest_exact_spearman = 9;

/// Returns Pearson's correlation of the ranks, with mean ranks of ties. Above `largest_exact` pairs
/// the P-value is the approximation by Student's t with n - 2 degrees of freedom (as R's cor.test
/// with exact = FALSE). The interval is Fisher's z with the variance (1 + r^2 / 2) / (n - 3) of
/// Bonett and Wright (2000). All values are finite. Empty if pearson is.
std::optional<Correlation> spearman(std::span<const double> x, std::span<const double> y,
                                    double confidence = default_confidence,
                                    std::size_t largest_exact = largest_exact_spearman);

struct Ranks {
  /// Each value's rank, from 1; ties have the mean of their ranks. Multiples of 1/2.
  std::vector<double> ranks;
  double tie_correction = 0.0;  ///< Sum of t^3 - t over groups of t equal values.
};

/// Returns the values without their last bits, on which ranks would depend: in means of logarithms
/// and of ratings these are only errors of floating-point arithmetic.
std::vector<double> without_rounding(std::vector<double> values);

/// All values are finite.
Ranks rank(std::span<const double> values);

}  // namespace foveola::analysis
