#include "analysis/dataset/primary_analysis.h"

#include <fmt/format.h>

#include "analysis/statistics/models/crossed_model.h"

namespace foveola::analysis {
namespace {

/// Joins two reasons, either of which may be empty.
std::string join_reasons(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + "; " + b;
}

std::string without_model(AnalysisKind kind, const FittedModel* tried) {
  return tried == nullptr ? fmt::format("the {} needs R (analyze --r)", name_of(kind))
                          : fmt::format("R could not fit the {}: {}", name_of(kind), tried->note);
}

bool has_fit(const FittedModel* model) { return model != nullptr && model->fit; }

PrimaryResult fitted(AnalysisKind kind, const FittedModel& model) {
  return {.kind = kind,
          .scale = model.scale,
          .estimate = model.fit->estimate,
          .interval = model.fit->interval,
          .standard_error = model.fit->standard_error,
          .degrees_of_freedom = model.fit->degrees_of_freedom,
          .p = model.fit->p,
          .scenes = model.scenes,
          .is_by_r = true,
          .warning = model.note,
          .influence_by_r = model.influence};
}

std::optional<PrimaryResult> over_participants(const PrimarySources& sources, EffectScale scale,
                                               const std::string& instead) {
  if (!sources.t) {
    return std::nullopt;
  }
  return PrimaryResult{.kind = AnalysisKind::participant_t,
                       .scale = scale,
                       .instead = instead,
                       .estimate = sources.t->mean,
                       .interval = sources.t->interval,
                       .standard_error = sources.t->standard_error(),
                       .degrees_of_freedom = sources.t->degrees_of_freedom,
                       .p = sources.t->p,
                       .scenes = sources.pairs.scenes()};
}

std::optional<PrimaryResult> crossed_in_closed_form(const PrimarySources& sources,
                                                    EffectScale scale, const std::string& instead) {
  const RepeatedMeasures complete = complete_participants(sources.pairs.differences);
  const std::optional<CrossedModel> model = crossed_model(complete);
  if (!model || !model->test) {
    return std::nullopt;
  }
  const bool is_complete = complete.participants == sources.pairs.participants();
  const std::string of_whom =
      is_complete
          ? ""
          : fmt::format("of the {} of {} participants with all scenes, because with gaps {}",
                        complete.participants, sources.pairs.participants(),
                        without_model(AnalysisKind::crossed_model, sources.crossed));
  return PrimaryResult{.kind = AnalysisKind::crossed_model,
                       .scale = scale,
                       .instead = join_reasons(instead, of_whom),
                       .estimate = model->mean,
                       .interval = model->test->interval,
                       .standard_error = model->test->standard_error,
                       .degrees_of_freedom = model->test->degrees_of_freedom,
                       .p = model->test->p,
                       .scenes = model->scenes};
}

std::optional<PrimaryResult> of_measured_pairs(const PrimarySources& sources, EffectScale scale,
                                               const study::AnalysisPlan& plan,
                                               const std::string& instead) {
  if (plan.scenes == study::SceneEffects::fixed) {
    return over_participants(sources, scale, instead);
  }
  if (!sources.pairs.is_complete() && has_fit(sources.crossed)) {
    PrimaryResult result = fitted(AnalysisKind::crossed_model, *sources.crossed);
    result.instead = instead;
    return result;
  }
  if (std::optional<PrimaryResult> closed = crossed_in_closed_form(sources, scale, instead)) {
    return closed;
  }
  const std::string why = sources.pairs.scenes() < 2
                              ? "one scene"
                              : "too few participants have all scenes, and with gaps " +
                                    without_model(AnalysisKind::crossed_model, sources.crossed);
  return over_participants(sources, scale, join_reasons(instead, why));
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

std::optional<PrimaryResult> primary_of_times(const PrimarySources& sources,
                                              const study::AnalysisPlan& plan) {
  const std::size_t censored = sources.pairs.censored;
  if (censored == 0) {
    return of_measured_pairs(sources, EffectScale::ratio, plan, "");
  }
  if (has_fit(sources.tobit)) {
    return fitted(AnalysisKind::tobit_model, *sources.tobit);
  }
  std::optional<PrimaryResult> stand_in = of_measured_pairs(
      sources, EffectScale::ratio, plan,
      fmt::format("{} with a right-censored time left out, which biases the ratio; {}",
                  censored == 1 ? "one pair" : fmt::format("{} pairs", censored),
                  without_model(AnalysisKind::tobit_model, sources.tobit)));
  if (stand_in) {
    stand_in->omits_censored = true;
  }
  return stand_in;
}

std::optional<PrimaryResult> primary_of_ratings(const PrimarySources& sources,
                                                const study::AnalysisPlan& plan, bool has_points) {
  const bool wants_model = plan.ratings == study::RatingAnalysis::ordinal_model;
  if (wants_model && !has_points) {
    return of_measured_pairs(sources, EffectScale::points, plan, "");
  }
  if (wants_model && has_fit(sources.ordinal)) {
    return fitted(AnalysisKind::ordinal_model, *sources.ordinal);
  }
  if (!sources.ranks || !sources.pseudo_median) {
    return std::nullopt;
  }
  return PrimaryResult{
      .kind = AnalysisKind::signed_ranks,
      .scale = EffectScale::points,
      .instead = wants_model ? without_model(AnalysisKind::ordinal_model, sources.ordinal) : "",
      .estimate = sources.pseudo_median->value,
      .interval = sources.pseudo_median->interval,
      .p = sources.ranks->p,
      .scenes = sources.pairs.scenes()};
}

}  // namespace foveola::analysis
