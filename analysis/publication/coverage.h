// How often the analysis is right: intervals and tests over thousands of studies with injected
// effects.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A share of studies, in per cent.
struct CoverageFigure {
  std::string name;
  std::string claim;        ///< what the share is of
  std::size_t studies = 0;  ///< in which it is defined
  std::size_t hits = 0;
  double percent = 0.0;
  Interval interval;              ///< of `percent`, Clopper and Pearson's
  std::optional<Interval> asked;  ///< nothing where it is only reported
  bool is_met() const { return !asked || (percent >= asked->low && percent <= asked->high); }
};

struct CoverageSettings {
  int studies = 4000;
  int participants = 16;
  std::uint64_t seed = 1;
  int resamples = 1999;  ///< of each bootstrap
  int threads = 0;       ///< 0: every core; the figures do not depend on it
};

/// Injected effects in t intervals on logs and order; null studies in every test.
/// `on_progress` is told the share that is done. Empty when `stop` was requested.
std::vector<CoverageFigure> measure_coverage(const CoverageSettings& settings,
                                             const std::function<void(double)>& on_progress,
                                             const std::stop_token& stop);

}  // namespace foveola::analysis
