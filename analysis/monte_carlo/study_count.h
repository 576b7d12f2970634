// Counts in how many studies something holds, on all threads.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "analysis/dataset/primary_analysis.h"
#include "renderer/base/exact_sum.h"
#include "renderer/base/parallel.h"

namespace foveola::analysis {

struct StudyCount {
  std::size_t studies = 0;  ///< Studies in which it is defined.
  std::size_t hits = 0;     ///< Studies in which it holds.
  ExactSum estimates;       ///< Of logarithms of ratios, where these are estimated.

  /// Of a study; empty where it is not defined.
  void add(std::optional<bool> holds);
  /// Of a study with an interval, which is to cover the truth.
  void add(const PrimaryResult& result, double truth);
  void add(const StudyCount& other);
  /// Of one study at least: the geometric mean of the ratios whose logarithms were estimated.
  double mean_ratio() const;
};

/// One for each figure.
using StudyCounts = std::vector<StudyCount>;

/// Adds count by count: there are as many of both.
void add(const StudyCounts& counts, StudyCounts& sums);

/// The sums of the `figures` counts that count(first, last) returns for blocks of `block` of so
/// many studies, on all threads.
StudyCounts sum_of_blocks(
    std::size_t figures, std::size_t studies, std::size_t block, const Workers& workers,
    const std::function<StudyCounts(std::size_t first, std::size_t last)>& count);

}  // namespace foveola::analysis
