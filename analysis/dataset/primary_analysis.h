// Selects the primary analysis: the source of a comparison's estimate, interval and P-value.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "analysis/dataset/fitted_model.h"
#include "analysis/dataset/participant_values.h"
#include "analysis/statistics/paired_t.h"
#include "analysis/statistics/rank_tests.h"
#include "study/protocol/protocol.h"

namespace foveola::analysis {

enum class AnalysisKind {
  crossed_model,  ///< Mixed model of log times or points, participants and scenes random.
  participant_t,  ///< Paired t over participants, in these scenes.
  tobit_model,    ///< Of single trials, some right-censored; for other scenes too, if scenes
  ///< are random.
  ordinal_model,  ///< Cumulative link mixed model of ratings.
  signed_ranks,   ///< Wilcoxon's test of participants' mean ratings.
};

/// Returns "crossed mixed model", "paired t over participants" and so on.
const char* name_of(AnalysisKind kind);

struct PrimaryResult {
  AnalysisKind kind = AnalysisKind::participant_t;
  EffectScale scale = EffectScale::ratio;
  /// Reason why it replaces the planned analysis; empty if it is the planned one.
  std::string instead;
  double estimate = 0.0;  ///< As the scale is computed, like the interval.
  std::optional<Interval> interval;
  // Present if p is by Student's t.
  std::optional<double> standard_error;
  std::optional<double> degrees_of_freedom;
  double p = 0.0;          ///< Two-sided.
  std::size_t scenes = 0;  ///< Number of scenes in the estimate.
  bool is_by_r = false;
  std::string warning;  ///< Warning of R; empty if there is none.
  std::optional<Influence> influence_by_r;
  bool omits_censored =
      false;  ///< Whether it is biased, as pairs with a right-censored time are left out.

  /// Returns the estimate and its interval as a ratio, an odds ratio or points.
  Estimate scaled() const {
    return {.value = in_scale(scale, estimate),
            .interval = interval ? std::optional(in_scale(scale, *interval)) : std::nullopt};
  }
};

/// Candidates for a primary analysis.
struct PrimarySources {
  const PairedTrials& pairs;
  std::optional<TTest> t;  ///< Over participants, of log ratios or points.
  std::optional<SignedRankTest> ranks;
  std::optional<PseudoMedian> pseudo_median;
  // By R; null if R was not asked.
  const FittedModel* crossed = nullptr;
  const FittedModel* tobit = nullptr;
  const FittedModel* ordinal = nullptr;
};

/// Returns the planned primary analysis of times. With right-censored times it is the Tobit model;
/// else the crossed mixed model, or with fixed scenes the paired t over participants. If R would
/// have to fit it and did not, the best available analysis replaces it, and `instead` says why.
/// Empty if there is none.
std::optional<PrimaryResult> primary_of_times(const PrimarySources& sources,
                                              const study::AnalysisPlan& plan);

/// Returns the planned primary analysis of ratings: signed ranks, or a model. That is the
/// cumulative link mixed model if the scale has_points (few enough for thresholds), else the model
/// of times.
std::optional<PrimaryResult> primary_of_ratings(const PrimarySources& sources,
                                                const study::AnalysisPlan& plan, bool has_points);

}  // namespace foveola::analysis
