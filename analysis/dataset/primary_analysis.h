// The one analysis that a comparison's estimate, interval and P-value are taken from.
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
  tobit_model,    ///< Of single trials, some right-censored; of other scenes, too, where they are
                  ///< random.
  ordinal_model,  ///< Cumulative link mixed model of ratings.
  signed_ranks,   ///< Wilcoxon's test of participants' mean ratings.
};

/// "crossed mixed model", "paired t over participants" and so on.
const char* name_of(AnalysisKind kind);

struct PrimaryResult {
  AnalysisKind kind = AnalysisKind::participant_t;
  EffectScale scale = EffectScale::ratio;
  /// Why it stands in for the analysis that is planned; empty if it is that one.
  std::string instead;
  double estimate = 0.0;  ///< As the scale is computed with, and so is the interval.
  std::optional<Interval> interval;
  // Where p is that of Student's t.
  std::optional<double> standard_error;
  std::optional<double> degrees_of_freedom;
  double p = 0.0;          ///< Two-sided.
  std::size_t scenes = 0;  ///< Those that it rests on.
  bool is_by_r = false;
  std::string warning;  ///< Of R; empty if there is none.
  std::optional<Influence> influence_by_r;
  bool omits_censored = false;  ///< Pairs with a right-censored time are left out: it is biased.

  /// The estimate and its interval as a ratio, an odds ratio or points.
  Estimate scaled() const {
    return {.value = in_scale(scale, estimate),
            .interval = interval ? std::optional(in_scale(scale, *interval)) : std::nullopt};
  }
};

/// What a primary analysis is taken from.
struct PrimarySources {
  const PairedTrials& pairs;
  std::optional<TTest> t;  ///< Over participants, of log ratios or points.
  std::optional<SignedRankTest> ranks;
  std::optional<PseudoMedian> pseudo_median;
  // By R; nullptr if it was not asked.
  const FittedModel* crossed = nullptr;
  const FittedModel* tobit = nullptr;
  const FittedModel* ordinal = nullptr;
};

/// The primary analysis of times, by the plan: with right-censored times the Tobit model; else the
/// crossed mixed model, or with fixed scenes the paired t over participants. Where R would have to
/// fit it and did not, the best of what there is stands in, and `instead` says why. Empty if there
/// is none.
std::optional<PrimaryResult> primary_of_times(const PrimarySources& sources,
                                              const study::AnalysisPlan& plan);

/// The primary analysis of ratings, by the plan: signed ranks, or the cumulative link mixed model
/// of a scale that has_points (few enough for thresholds) and, of any other, what times have.
std::optional<PrimaryResult> primary_of_ratings(const PrimarySources& sources,
                                                const study::AnalysisPlan& plan, bool has_points);

}  // namespace foveola::analysis
