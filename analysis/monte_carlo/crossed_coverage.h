// How often the primary analyses of times are right where people and scenes differ in their ratios.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/monte_carlo/coverage.h"
#include "analysis/statistics/crossed_study.h"

namespace foveola::analysis {

/// 12, 16, 24 and 40 participants in five scenes, whose second method takes half of the time, with
/// standard deviations of 0, 0.1 and 0.2 log units between people's and between scenes' ratios.
std::vector<CrossedDesign> crossed_designs();
/// "16 × 5, SD 0.1 people, 0.2 scenes"
std::string design_in_words(const CrossedDesign& design);

/// The coverage of the crossed mixed model and of the paired t over participants, for the ratio in
/// other scenes, too, in each of crossed_designs(). The error of the first kind is 100 % less the
/// coverage. Required of the crossed model alone, and above 95 % no more than is due to variances
/// that cannot be below zero (data/golden/README.md); t does not speak of other scenes. Each study
/// is a function of the seed and its number alone. Uses the settings' studies, seed and threads.
/// Calls `on_progress` with the share that is done. Empty when `stop` was requested.
std::vector<CoverageFigure> measure_crossed_coverage(const CoverageSettings& settings,
                                                     const std::function<void(double)>& on_progress,
                                                     const std::stop_token& stop);

}  // namespace foveola::analysis
