// How far the analyses that stand in for a Tobit model without R are right.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "analysis/monte_carlo/coverage.h"

namespace foveola::analysis {

/// Counts, in each of crossed_designs() with 13 and 32 % of the baseline's times right-censored,
/// how often what analyze reports without R covers, with random and with fixed scenes, and the mean
/// of its ratios; 0.5 was drawn. It is of the pairs without a censored time. All are only reported:
/// the interval is not offered without a warning, and this is why. Each study is a function of the
/// seed and its number alone. Uses the settings' studies, seed and threads. Calls `on_progress`
/// with the share that is done. Empty when `stop` was requested.
std::vector<CoverageFigure> measure_censored_coverage(
    const CoverageSettings& settings, const std::function<void(double)>& on_progress,
    const std::stop_token& stop);

}  // namespace foveola::analysis
