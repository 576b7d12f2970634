// Measures the coverage of the primary analyses of times without R under censoring.
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

/// Counts how often the results of analyze without R cover the truth, with random and with fixed
/// scenes, and the mean of its ratios; 0.5 was drawn. It does so in each of crossed_designs() with
/// 13 and 32 % of the baseline's times right-censored. Results are of pairs without a censored
/// time, which is why they come with a warning; the figures are reported without a requirement.
/// Each study is a function of the seed and its number alone. Uses the settings' studies, seed and
/// threads. Calls `on_progress` with the fraction done. Empty when `stop` was requested.
std::vector<CoverageFigure> measure_censored_coverage(
    const CoverageSettings& settings, const std::function<void(double)>& on_progress,
    const std::stop_token& stop);

/// Returns designs of 12, 16, 24 and 40 participants in five scenes, whose second method takes half
/// of the time, with standard deviations of 0, 0.1 and 0.2 log units between people's and between
/// scenes' ratios.
std::vector<CrossedDesign> crossed_designs();
/// Returns "16 × 5, SD 0.1 people, 0.2 scenes".
std::string design_in_words(const CrossedDesign& design);

/// Measures the coverage of the crossed mixed model and of the paired t over participants, for the
/// ratio in all scenes, in each of crossed_designs(). The type I error rate is 100 % less the
/// coverage. Only the crossed model has a requirement: above 95 % by no more than is due to
/// variances that cannot be below zero (data/golden/README.md). t does not generalise to other
/// scenes. Each study is a function of the seed and its number alone. Uses the settings' studies,
/// seed and threads. Calls `on_progress` with the fraction done. Empty when `stop` was requested.
std::vector<CoverageFigure> measure_crossed_coverage(const CoverageSettings& settings,
                                                     const std::function<void(double)>& on_progress,
                                                     const std::stop_token& stop);

struct GainDesign {
  double participants_gain = 0.0;  ///< Standard deviation between their log ratios.
  double scenes_gain = 0.0;
  double censored = 0.0;  ///< Fraction of the baseline's times that is right-censored; below 1.
  study::SceneEffects scenes = study::SceneEffects::random;
  double ratio = 0.5;              ///< Times of `fv` over those of `od`.
  std::optional<double> margin{};  ///< Of equivalence, a ratio above 1.
};

/// Returns a study of the mark `outline` in five scenes with the methods `od` and `fv`, its planned
/// comparison. Standard deviations of log times are 0.5 between people and between scenes, equal
/// for both methods, and 0.3 between trials.
ExpectedStudy gain_study(const GainDesign& design);

/// Returns a study of the rating `artifacts` of the same design, whose methods do not differ: the
/// planned comparison. Standard deviations in fractions of the scale's width: 0.15 between people,
/// 0.05 between scenes, of the gain 0.1 between people and 0.05 between scenes, 0.2 between trials.
ExpectedStudy rating_study();

/// Returns the planned methods' mean log ratio over the scenes that draw_study draws with the seed.
/// The design's own ratio is that in the population of scenes.
double log_ratio_in_drawn_scenes(const ExpectedStudy& expected, std::uint64_t seed);

}  // namespace foveola::analysis
