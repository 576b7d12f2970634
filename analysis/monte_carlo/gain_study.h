// Studies of two methods in which people and scenes differ in what they gain, and times run out.
#pragma once

#include <optional>

#include "analysis/monte_carlo/expected_study.h"

namespace foveola::analysis {

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
