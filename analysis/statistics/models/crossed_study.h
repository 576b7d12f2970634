// Draws studies from a crossed model, to measure the coverage of its analyses' intervals.
#pragma once

#include <cstddef>
#include <cstdint>

#include "analysis/statistics/descriptive.h"
#include "analysis/statistics/repeated_measures.h"
#include "renderer/base/numbers/random.h"

namespace foveola::analysis {

/// A study of two methods, both used by every participant in every scene. Standard deviations are
/// of natural logarithms of times, and not below zero.
struct CrossedDesign {
  std::size_t participants = 16;
  std::size_t scenes = 5;
  double mean = 0.0;            ///< The mean log ratio of the two methods' times.
  double participant_sd = 0.0;  ///< Between participants, of their mean log ratios.
  double scene_sd = 0.0;        ///< Between scenes, of their mean log ratios.
  double residual_sd = 0.3;     ///< Residual of one time; a log ratio's is sqrt(2) times that.
};

/// Draws the log ratios [participant][scene] of one study.
RepeatedMeasures draw_log_ratios(const CrossedDesign& design, Pcg32& generator);

/// Number of studies in which an interval covers a value of the mean log ratio. In the others the
/// test of this value rejects it: a type I error if it is the design's mean, power if it is 0 and
/// the mean is not.
struct CrossedCoverage {
  std::size_t studies = 0;
  std::size_t crossed_model = 0;      ///< By crossed_model's interval.
  std::size_t over_participants = 0;  ///< By test_ratio of the participants' mean log ratios.
};

/// Counts over the studies first ... last - 1. Each is a function of the seed and its number alone,
/// so that parts of a simulation may be counted separately and added. The design has at least two
/// participants and two scenes, and a residual.
CrossedCoverage count_coverage(const CrossedDesign& design, double value, std::uint64_t seed,
                               std::uint64_t first, std::uint64_t last,
                               double confidence = default_confidence);

}  // namespace foveola::analysis
