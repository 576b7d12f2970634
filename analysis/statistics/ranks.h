// Ranks with ties, for the rank tests.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace foveola::analysis {

struct Ranks {
  /// Each value's rank, from 1; equal values share the mean of their ranks. Multiples of 1/2.
  std::vector<double> ranks;
  double tie_correction = 0.0;  ///< Sum of t^3 - t over groups of t equal values.
};

/// Rounds off the last bits, on which ranks would depend: in means of logarithms and of ratings
/// these are only the errors of floating-point arithmetic.
std::vector<double> without_rounding(std::vector<double> values);

/// All values are finite.
Ranks rank(std::span<const double> values);

}  // namespace foveola::analysis
