// Pairs of values of the same participants, as the differences and log ratios that tests take.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "analysis/statistics/logarithms.h"

namespace foveola::analysis {

/// a[i] - b[i]; both of one size.
inline std::vector<double> differences(std::vector<double> a, const std::vector<double>& b) {
  std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::minus<>());
  return a;
}

/// The logarithms of a[i] / b[i].
inline std::vector<double> log_ratios(const std::vector<double>& a, const std::vector<double>& b) {
  return differences(logarithms(a), logarithms(b));
}

}  // namespace foveola::analysis
