// The mean of values some of which are only known to lie beyond a bound: marks that timed out.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A value, or all that is known of it: that it lies between low and high. A measured value has
/// both alike; a time that was cut off at c (its logarithm) has c and infinity; a logarithm of a
/// ratio whose baseline was cut off has minus infinity and its own.
struct BoundedValue {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  static BoundedValue exactly(double value) { return {value, value}; }
  bool is_exact() const { return low == high; }
  /// Neither end: it says nothing.
  bool is_unknown() const;
};

/// What is known of a - b.
BoundedValue difference(const BoundedValue& a, const BoundedValue& b);

struct CensoredMean {
  std::size_t n = 0;         ///< values that say something
  std::size_t censored = 0;  ///< of these, those with a bound only
  std::size_t unknown = 0;   ///< values that say nothing, which are left out
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< with n - 1, as without censoring
  double standard_error = 0.0;
  Interval interval;  ///< of the mean
  double t = 0.0;     ///< mean / standard error, with n - 1 degrees of freedom
  double p = 0.0;     ///< two-sided, of a mean of zero
};

/// The mean of normal values by maximum likelihood (Tobin 1958; as R's survreg with "gaussian"),
/// with the standard error of the observed information times sqrt(n / (n - 1)) and Student's t with
/// n - 1 degrees of freedom: without censored values it is the t interval and the t test, exactly.
/// Empty where the likelihood has no peak: fewer than two measured values, or none that differ.
std::optional<CensoredMean> censored_mean(std::span<const BoundedValue> values,
                                          double confidence = default_confidence);

}  // namespace foveola::analysis
