// How far the analyses that stand in for a Tobit model without R are right.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "analysis/monte_carlo/coverage.h"

namespace foveola::analysis {

/// What count_censored_coverage() counts, before it is counted: in each of crossed_designs(), with
/// 13 and 32 % of the baseline's times right-censored, the coverage of what analyze reports without
/// R with random and with fixed scenes, which is of the pairs without a censored time, and the mean
/// of its ratios; 0.5 was drawn. All are only reported: the interval is not offered without a
/// warning, and this is why.
std::vector<CoverageFigure> censored_figures();

/// The counts of censored_figures() over these studies, each of which is a function of the seed and
/// its number alone. Uses the settings' seed and threads. Calls `on_progress` with the share that
/// is done. Empty when `stop` was requested.
StudyCounts count_censored_coverage(const CoverageSettings& settings, const ItemRange& studies,
                                    const std::function<void(double)>& on_progress,
                                    const std::stop_token& stop);

}  // namespace foveola::analysis
