#include "analysis/dataset/primary_analysis.h"

#include <cmath>

#include <fmt/format.h>

#include "analysis/statistics/crossed_model.h"

namespace foveola::analysis {
namespace {

std::optional<PrimaryResult> fitted(AnalysisKind kind, const FittedModel& model) {
  return PrimaryResult{.kind = kind,
                       .estimate = model.fit->estimate,
                       .interval = model.fit->interval,
                       .degrees_of_freedom = model.fit->degrees_of_freedom,
                       .p = model.fit->p};
}

std::optional<PrimaryResult> over_participants(const std::optional<RatioTest>& ratio,
                                               const std::string& instead) {
  if (!ratio) {
    return std::nullopt;
  }
  return PrimaryResult{.kind = AnalysisKind::participant_t,
                       .instead = instead,
                       .estimate = ratio->logs.mean,
                       .interval = ratio->logs.interval,
                       .degrees_of_freedom = ratio->logs.degrees_of_freedom,
                       .p = ratio->logs.p};
}

/// In closed form, of the participants who have all scenes.
std::optional<PrimaryResult> crossed_in_closed_form(const PairedTrials& pairs,
                                                    const std::string& instead) {
  const RepeatedMeasures complete = complete_participants(pairs.differences);
  const std::optional<CrossedModel> model = crossed_model(complete);
  if (!model || !model->test) {
    return std::nullopt;
  }
  const std::size_t left_out = pairs.participants() - complete.participants;
  return PrimaryResult{
      .kind = AnalysisKind::crossed_model,
      .instead = left_out == 0
                     ? instead
                     : fmt::format("{}{} of {} participants, who have all scenes; R fits it to all "
                                   "pairs (analyze --r)",
                                   instead.empty() ? "" : instead + "; ", complete.participants,
                                   pairs.participants()),
      .estimate = model->mean,
      .interval = model->test->interval,
      .degrees_of_freedom = model->test->degrees_of_freedom,
      .p = model->test->p};
}

/// Of measured times: what the plan says.
std::optional<PrimaryResult> of_measured_times(const PairedTrials& pairs,
                                               const ParticipantResults& results,
                                               const study::AnalysisPlan& plan,
                                               const FittedModel* crossed,
                                               const std::string& instead) {
  if (plan.scenes == study::SceneEffects::fixed) {
    return over_participants(results.ratio, instead);
  }
  if (!pairs.is_complete() && crossed != nullptr && instead.empty()) {
    return fitted(AnalysisKind::crossed_model, *crossed);
  }
  if (std::optional<PrimaryResult> closed = crossed_in_closed_form(pairs, instead)) {
    return closed;
  }
  const std::string why =
      pairs.scenes() < 2 ? "one scene" : "too few participants have all scenes without R";
  return over_participants(results.ratio, instead.empty() ? why : instead + "; " + why);
}

}  // namespace

const char* name_of(AnalysisKind kind) {
  switch (kind) {
    case AnalysisKind::crossed_model:
      return "crossed mixed model";
    case AnalysisKind::participant_t:
      return "paired t over participants";
    case AnalysisKind::tobit_model:
      return "Tobit model";
    case AnalysisKind::ordinal_model:
      return "cumulative link mixed model";
    case AnalysisKind::signed_ranks:
      return "signed ranks";
  }
  return "";
}

const char* scale_of(AnalysisKind kind) {
  return kind == AnalysisKind::ordinal_model  ? "odds ratio"
         : kind == AnalysisKind::signed_ranks ? "points"
                                              : "ratio";
}

double PrimaryResult::in_scale(double value) const {
  return kind == AnalysisKind::signed_ranks ? value : std::exp(value);
}

std::optional<PrimaryResult> primary_of_times(const PairedTrials& pairs,
                                              const ParticipantResults& results,
                                              const study::AnalysisPlan& plan,
                                              const FittedModel* crossed,
                                              const FittedModel* tobit) {
  if (pairs.censored == 0) {
    return of_measured_times(pairs, results, plan, crossed, "");
  }
  if (tobit != nullptr) {
    return fitted(AnalysisKind::tobit_model, *tobit);
  }
  return of_measured_times(
      pairs, results, plan, crossed,
      fmt::format("{} with a right-censored time left out, which biases the ratio; R fits "
                  "a Tobit model to all (analyze --r)",
                  pairs.censored == 1 ? "one pair" : fmt::format("{} pairs", pairs.censored)));
}

std::optional<PrimaryResult> primary_of_ratings(const ParticipantResults& results,
                                                const study::AnalysisPlan& plan, bool has_points,
                                                const FittedModel* ordinal) {
  const bool wants_model = has_points && plan.ratings == study::RatingAnalysis::ordinal_model;
  if (wants_model && ordinal != nullptr) {
    return fitted(AnalysisKind::ordinal_model, *ordinal);
  }
  if (!results.ranks || !results.pseudo_median) {
    return std::nullopt;
  }
  return PrimaryResult{
      .kind = AnalysisKind::signed_ranks,
      .instead = wants_model ? "the cumulative link mixed model needs R (analyze --r)" : "",
      .estimate = results.pseudo_median->value,
      .interval = results.pseudo_median->interval,
      .p = results.ranks->p};
}

}  // namespace foveola::analysis
