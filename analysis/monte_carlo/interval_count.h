// Counting in how many studies an interval covers what was drawn.
#pragma once

#include <cmath>
#include <cstddef>

#include "analysis/dataset/primary_analysis.h"

namespace foveola::analysis {

struct IntervalCount {
  std::size_t studies = 0;
  std::size_t covered = 0;
  double estimates = 0.0;  ///< Their sum.

  /// Of a study with an interval.
  void add(const PrimaryResult& result, double truth) {
    ++studies;
    covered += result.interval->low <= truth && truth <= result.interval->high ? 1 : 0;
    estimates += result.estimate;
  }
  void add(const IntervalCount& other) {
    studies += other.studies;
    covered += other.covered;
    estimates += other.estimates;
  }
  /// Of one study at least: the geometric mean of the ratios whose logarithms were estimated.
  double mean_ratio() const { return std::exp(estimates / static_cast<double>(studies)); }
};

}  // namespace foveola::analysis
