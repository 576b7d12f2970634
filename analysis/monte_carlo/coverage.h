// How often the analysis is right: the coverage of its intervals and the error rates of its tests,
// over thousands of studies with injected effects.
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
#include "renderer/base/exact_sum.h"
#include "renderer/base/work/parallel.h"

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

/// A share of studies, in per cent.
struct CoverageFigure {
  std::string name;
  std::string claim;        ///< What holds in so many studies, as "rejects at 5 %".
  std::size_t studies = 0;  ///< Studies in which it is defined.
  std::size_t hits = 0;     ///< Studies in which it holds.
  double percent = 0.0;
  Interval interval;                 ///< Clopper and Pearson's interval of `percent`.
  std::optional<Interval> required;  ///< Empty where the share is only reported.
  /// Of so few studies that it is enough if `interval` reaches into the required range.
  bool few_studies = false;
  bool estimates_ratios = false;     ///< The studies' estimates are logarithms of ratios.
  std::optional<double> mean_ratio;  ///< Geometric mean of these ratios; empty without a study.

  bool is_met() const {
    const Interval share = few_studies ? interval : Interval{percent, percent};
    return !required || (share.high >= required->low && share.low <= required->high);
  }
};

/// The figure with the studies that were counted.
CoverageFigure measured(CoverageFigure figure, const StudyCount& count);

struct CoverageSettings {
  std::size_t studies = 4000;
  int participants = 16;
  std::uint64_t seed = 1;
  int resamples = 1999;  ///< Resamples of each bootstrap interval.
  int threads = 0;       ///< 0 takes every core; the figures do not depend on it.
};

/// The coverage of intervals over studies with injected effects, and the rejections of every test
/// over studies without an effect. Each study is a function of the seed and its number alone. Calls
/// `on_progress` with the share that is done. Empty when `stop` was requested.
std::vector<CoverageFigure> measure_injected_coverage(
    const CoverageSettings& settings, const std::function<void(double)>& on_progress,
    const std::stop_token& stop);

}  // namespace foveola::analysis
