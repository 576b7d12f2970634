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

#include "analysis/monte_carlo/study_count.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

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
