// Ranks with ties, for the tests that look at nothing else.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace foveola::analysis {

struct Ranks {
  /// Of each value, from 1; equal values share the mean of their ranks. Multiples of 1/2.
  std::vector<double> ranks;
  double tie_correction = 0.0;  ///< sum over groups of equal values, t of them, of t^3 - t
};

/// All values finite.
Ranks rank(std::span<const double> values);

}  // namespace foveola::analysis
