// How often the primary analyses of times are right: without R, and where people and scenes differ.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/monte_carlo/coverage.h"
#include "analysis/monte_carlo/expected_study.h"
#include "analysis/statistics/models/crossed_study.h"

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

struct GainDesign {
  double participants_gain = 0.0;  ///< Standard deviations between their log ratios.
  double scenes_gain = 0.0;
  double censored = 0.0;  ///< The share of the baseline's times that is right-censored; below 1.
  study::SceneEffects scenes = study::SceneEffects::random;
  double ratio = 0.5;              ///< Of the times of `fv` to those of `od`.
  std::optional<double> margin{};  ///< Of equivalence, a ratio above 1.
};

/// The mark `outline` in five scenes with the methods `od` and `fv`; this is the planned
/// comparison. Standard deviations of log times: 0.5 between people and between scenes, whose times
/// with the other method are as long, and 0.3 between trials.
ExpectedStudy gain_study(const GainDesign& design);

/// The rating `artifacts` of the same, in which the methods do not differ: the planned comparison.
/// Standard deviations in parts of the scale's width: 0.15 between people, 0.05 between scenes, of
/// the gain 0.1 between people and 0.05 between scenes, 0.2 between trials.
ExpectedStudy rating_study();

/// The log ratio of the planned methods in the scenes that draw_study draws with the seed, mean
/// over them; the design's own is that in all scenes like these.
double log_ratio_in_drawn_scenes(const ExpectedStudy& expected, std::uint64_t seed);

}  // namespace foveola::analysis
