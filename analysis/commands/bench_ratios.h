// How the figures of two runs of a benchmark compare.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A figure that both runs have.
struct BenchRatio {
  std::string figure;  ///< where it stands: "runs[threads=2].seconds"
  double before = 0.0;
  double after = 0.0;
  double ratio = 0.0;                ///< after / before
  std::optional<Interval> interval;  ///< the ratio's, where both figures have one of their own
};

struct BenchComparison {
  std::vector<BenchRatio> ratios;      ///< in the order of the earlier run's figures
  std::vector<std::string> differing;  ///< settings, "width: 1024, now 2048"
  std::vector<std::string> unmatched;  ///< figures that only one run has, or that have no ratio
};

/// Compares what any of the bench commands prints with --json. The elements of arrays belong
/// together if they are of the same name, scene, gaze, configuration, region, metric, level, kind,
/// threads and so on, wherever they stand; figures are the numbers in top-level arrays, and
/// everything else is a setting. The interval is that of a ratio of independent estimates, on the
/// logarithm (Zou and Donner 2008, "Construction of confidence limits about effect measures", eq. 9
/// for a difference). Names name the texts in errors. Throws Error for what is no JSON object, and
/// if the two have no figure in common.
BenchComparison compare_benches(const std::string& before, const std::string& before_name,
                                const std::string& after, const std::string& after_name);

}  // namespace foveola::analysis
