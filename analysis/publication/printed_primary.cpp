#include <cmath>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/printed_results.h"

namespace foveola::analysis {
namespace {

/// "45.2 [40.1, 51.0] %", "2.30 [1.20, 4.40] odds ratio" or "0.33 [0.10, 0.50] points" of what was
/// computed with.
std::string estimate_text(EffectScale scale, double estimate,
                          const std::optional<Interval>& interval) {
  const bool is_ratio = scale == EffectScale::ratio;
  const double factor = is_ratio ? 100.0 : 1.0;
  Estimate scaled{.value = factor * in_scale(scale, estimate)};
  if (interval) {
    const Interval ends = in_scale(scale, *interval);
    scaled.interval = {factor * ends.low, factor * ends.high};
  }
  return fmt::format("{} {}", with_interval(scaled, is_ratio ? 1 : 2),
                     is_ratio ? "%" : name_of(scale));
}

/// How many times sooner the method's mark came: the ratio's inverse.
std::string speed_up_text(const PrimaryResult& result) {
  if (result.scale != EffectScale::ratio) {
    return "–";
  }
  Estimate estimate{.value = std::exp(-result.estimate)};
  if (result.interval) {
    estimate.interval = {std::exp(-result.interval->high), std::exp(-result.interval->low)};
  }
  return with_interval(estimate, 2) + " ×";
}

std::string analysis_text(const PrimaryResult& result) {
  const std::string why = result.instead.empty() ? "" : fmt::format(" ({})", result.instead);
  const std::string warning = result.warning.empty() ? "" : fmt::format("; R: {}", result.warning);
  return name_of(result.kind) + why + warning;
}

std::vector<std::string> primary_row(const MethodComparison& row) {
  std::vector<std::string> cells = {compared_in_words(row), std::to_string(row.n),
                                    std::to_string(row.pairs)};
  if (row.primary) {
    const PrimaryResult& result = *row.primary;
    cells.push_back(estimate_text(result.scale, result.estimate, result.interval));
    cells.push_back(speed_up_text(result));
    cells.push_back(p_value(result.p));
    if (row.planned) {
      cells.push_back(p_value(row.p_holm.value()));
    }
    cells.push_back(analysis_text(result));
  } else {
    // One participant, or differences that do not vary, have an estimate and nothing else.
    const EffectScale scale = row.is_time ? EffectScale::ratio : EffectScale::points;
    cells.push_back(row.mean ? estimate_text(scale, *row.mean, std::nullopt) : "–");
    cells.push_back(row.mean ? speed_up_text({.scale = scale, .estimate = *row.mean}) : "–");
    cells.insert(cells.end(), row.planned ? 2 : 1, "–");
    cells.push_back(row.missing);
  }
  return cells;
}

}  // namespace

PrintedTable printed_primary(const Comparisons& comparisons, bool planned) {
  PrintedTable table;
  table.id = planned ? "planned-comparisons" : "exploratory-comparisons";
  table.title = planned ? "Planned comparisons." : "Exploratory comparisons, P-values unadjusted.";
  table.note = fmt::format(
      "The primary analysis of each, with its 95 % interval. {} Speed-up: how many times sooner "
      "the mark came.",
      comparisons.plan.scenes == study::SceneEffects::random
          ? "Mixed and Tobit models are of scenes and participants like these; a paired t and "
            "signed ranks are of participants like these in these scenes."
          : "All are of participants like these in these scenes.");
  table.columns = {"Methods, measure", "n", "pairs", "estimate [95 %]", "speed-up [95 %]", "P"};
  if (planned) {
    table.columns.emplace_back("P, Holm");
  }
  table.columns.emplace_back("analysis");
  for (const MethodComparison& row : comparisons.methods) {
    if (row.planned == planned) {
      table.rows.push_back(primary_row(row));
    }
  }
  return table;
}

PrintedTable printed_models(const Comparisons& comparisons) {
  PrintedTable table;
  table.id = "models";
  table.title = "Models by R.";
  table.note =
      "Crossed and Tobit models of log times: ratios in per cent; crossed models of ratings with "
      "many points: points; cumulative link mixed models of the other ratings: odds ratios of a "
      "higher one. Standard deviations are of the difference between the methods, in log units, "
      "points or logits.";
  table.columns = {"Methods, measure", "model", "trials", "right-censored",
                   "estimate [95 %]",  "df",    "P",      "SD, participants",
                   "SD, scenes",       "R says"};
  for (const FittedModel& model : comparisons.models.models) {
    std::vector<std::string> cells = {fmt::format("{} / {}, {}", method_label(model.method),
                                                  method_label(model.reference), model.measure),
                                      model.model, std::to_string(model.trials),
                                      std::to_string(model.censored)};
    if (model.fit) {
      cells.push_back(estimate_text(model.scale, model.fit->estimate, model.fit->interval));
      cells.push_back(fixed(model.fit->degrees_of_freedom, 1));
      cells.push_back(p_value(model.fit->p));
    } else {
      cells.insert(cells.end(), 3, "–");
    }
    cells.push_back(fixed(model.participant_sd, 3));
    cells.push_back(fixed(model.scene_sd, 3));
    cells.push_back(model.note);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace foveola::analysis
