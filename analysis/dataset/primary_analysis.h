// The one analysis that a comparison's estimate, interval and P-value are taken from.
#pragma once

#include <optional>
#include <string>

#include "analysis/dataset/fitted_model.h"
#include "analysis/dataset/participant_values.h"
#include "analysis/statistics/paired_t.h"
#include "analysis/statistics/pseudo_median.h"
#include "analysis/statistics/wilcoxon.h"
#include "study/protocol/protocol.h"

namespace foveola::analysis {

enum class AnalysisKind {
  crossed_model,  ///< Mixed model of log times, participants and scenes random.
  participant_t,  ///< Paired t over participants, in these scenes.
  tobit_model,    ///< Of single trials, some right-censored, in these scenes.
  ordinal_model,  ///< Cumulative link mixed model of ratings.
  signed_ranks,   ///< Wilcoxon's test of participants' mean ratings.
};

/// "crossed mixed model", "paired t over participants" and so on.
const char* name_of(AnalysisKind kind);

/// What an estimate is, after exp where it is a logarithm: "ratio", "odds ratio" or "points".
const char* scale_of(AnalysisKind kind);

struct PrimaryResult {
  AnalysisKind kind = AnalysisKind::participant_t;
  /// Why it stands in for the analysis that is planned; empty if it is that one.
  std::string instead;
  double estimate = 0.0;  ///< A logarithm of a ratio or of odds, or points.
  std::optional<Interval> interval;
  std::optional<double> degrees_of_freedom;
  double p = 0.0;  ///< Two-sided.

  /// An estimate as scale_of() says.
  double in_scale(double value) const;
};

/// The results over participants that a primary analysis may be.
struct ParticipantResults {
  std::optional<RatioTest> ratio;
  std::optional<SignedRankTest> ranks;
  std::optional<PseudoMedian> pseudo_median;
};

/// The primary analysis of times, by the plan: with right-censored times the Tobit model; else the
/// crossed mixed model, or with fixed scenes the paired t over participants. Where R would have to
/// fit it and did not, the best of what there is stands in, and `instead` says why. Empty if there
/// is none.
std::optional<PrimaryResult> primary_of_times(const PairedTrials& pairs,
                                              const ParticipantResults& results,
                                              const study::AnalysisPlan& plan,
                                              const FittedModel* crossed, const FittedModel* tobit);

/// The primary analysis of ratings: the cumulative link mixed model, or signed ranks if the plan
/// says so, the scale has too many points for thresholds, or there is no model.
std::optional<PrimaryResult> primary_of_ratings(const ParticipantResults& results,
                                                const study::AnalysisPlan& plan, bool has_points,
                                                const FittedModel* ordinal);

}  // namespace foveola::analysis
