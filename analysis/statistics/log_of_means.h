// Ratios and geometric means of arithmetic means over the same participants, with their intervals:
// the mean time of one method over another's, or the geometric mean over scenes of such means.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// The natural logarithm of a mean over participants, or of a product of powers of such means.
struct LogOfMeans {
  double value = 0.0;
  /// How far each participant's values move `value`, to first order; empty for a participant who
  /// has none. Those of a mean m of n values are (x - m) / (n m).
  std::vector<std::optional<double>> influences;
};

/// Of the mean of the participants' values, which are finite and above zero; some may lack. Empty
/// without any.
std::optional<LogOfMeans> log_of_mean(std::span<const std::optional<double>> values);

/// Of the ratio of two means of the same participants, in the same order.
LogOfMeans log_of_ratio(const LogOfMeans& numerator, const LogOfMeans& denominator);

/// Of the geometric mean of means of the same participants, in the same order; not of none.
LogOfMeans log_of_geometric_mean(std::span<const LogOfMeans> means);

/// What it is the logarithm of, with the interval exp(value -+ t s): the delta method, with
/// s^2 = n / (n - 1) times the sum of squared influences and t of n - 1 degrees of freedom, n the
/// participants with a value (Cochran 1977, Sampling Techniques, section 6.4, on the logarithm). Of
/// ratios of lognormal times with standard deviations of logarithms from 0.5 to 1, it covers 91 to
/// 95 % with 16 participants. No interval for fewer than two, or where s is no more than
/// rounding_of_logarithms.
Estimate estimate_of(const LogOfMeans& logarithm, double confidence = default_confidence);

}  // namespace foveola::analysis
