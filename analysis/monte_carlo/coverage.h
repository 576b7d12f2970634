// Measures the coverage of the analysis's intervals and the error rates of its tests, over
// thousands of studies with injected effects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/dataset/primary_analysis.h"
#include "analysis/statistics/descriptive.h"
#include "renderer/base/numbers/exact_sum.h"
#include "renderer/base/work/parallel.h"

namespace foveola::analysis {

struct StudyCount {
  std::size_t studies = 0;  ///< Studies in which the claim is defined.
  std::size_t hits = 0;     ///< Studies in which the claim holds.
  ExactSum estimates;       ///< Logarithms of ratios, if these are estimated.

  /// Adds a study; empty: the claim is not defined.
  void add(std::optional<bool> holds);
  /// Adds a study with an interval, which should cover `truth`.
  void add(const PrimaryResult& result, double truth);
  void add(const StudyCount& other);
  /// Returns the geometric mean of the ratios whose logarithms were estimated; needs at least one
  /// study.
  double mean_ratio() const;
};

/// One per figure.
using StudyCounts = std::vector<StudyCount>;

/// Adds count by count; both have the same length.
void add(const StudyCounts& counts, StudyCounts& sums);

/// Returns the sums of the `figures` counts that count(first, last) returns for blocks of `block`
/// studies, on all threads.
StudyCounts sum_of_blocks(
    std::size_t figures, std::size_t studies, std::size_t block, const Workers& workers,
    const std::function<StudyCounts(std::size_t first, std::size_t last)>& count);

/// A share of studies, in per cent.
struct CoverageFigure {
  std::string name;
  std::string claim;        ///< The claim, as "rejects at 5 %".
  std::size_t studies = 0;  ///< Studies in which the claim is defined.
  std::size_t hits = 0;     ///< Studies in which the claim holds.
  double percent = 0.0;
  Interval interval;                 ///< Clopper and Pearson's interval of `percent`.
  std::optional<Interval> required;  ///< Empty if the share is only reported.
  /// Whether so few studies that `interval` need only overlap the required range.
  bool few_studies = false;
  bool estimates_ratios = false;     ///< Whether the studies' estimates are logarithms of ratios.
  std::optional<double> mean_ratio;  ///< Geometric mean of these ratios; empty without a study.

  bool is_met() const {
    const Interval share = few_studies ? interval : Interval{percent, percent};
    return !required || (share.high >= required->low && share.low <= required->high);
  }
};

/// Returns the figure with the counted studies.
CoverageFigure measured(CoverageFigure figure, const StudyCount& count);

struct CoverageSettings {
  std::size_t studies = 4000;
  int participants = 16;
  std::uint64_t seed = 1;
  int resamples = 1999;  ///< Resamples of each bootstrap interval.
  int threads = 0;       ///< 0: one per core; the figures do not depend on it.
};

/// Measures the coverage of intervals over studies with injected effects, and the rejection rates
/// of every test over studies without an effect. Each study is a function of the seed and its
/// number alone. Calls `on_progress` with the fraction done. Empty when `stop` was requested.
std::vector<CoverageFigure> measure_injected_coverage(
    const CoverageSettings& settings, const std::function<void(double)>& on_progress,
    const std::stop_token& stop);

}  // namespace foveola::analysis
