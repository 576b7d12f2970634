#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/analyze_study.h"
#include "study/protocol/cautions.h"

namespace foveola::analysis {
namespace {

/// With so few scenes, intervals that generalise to other scenes undercover: see
/// data/golden/README.md. Empty if there are enough scenes, or if no planned result generalises to
/// others.
std::string few_scenes(const Comparisons& comparisons, std::size_t scenes) {
  const bool is_of_others =
      std::ranges::any_of(comparisons.methods, [](const MethodComparison& row) {
        return row.planned && row.primary && row.primary->kind == AnalysisKind::crossed_model;
      });
  return is_of_others && scenes < study::min_random_scenes
             ? fmt::format(
                   "{}: 95 % confidence intervals for scenes like these undercover (87 % with two, "
                   "92 % with three); plan five, or fixed scenes.",
                   count_with_noun(scenes, "scene"))
             : "";
}

}  // namespace

std::vector<std::string> warnings_about(const AnalysisOutput& output) {
  const StudyTables& tables = output.tables;
  std::vector<std::string> warnings;
  if (output.record && !output.record->faults.empty()) {
    warnings.push_back(fmt::format(
        "The study's file failed its verification ({}): any number may be wrong; foveola study "
        "verify lists the faults.",
        count_with_noun(output.record->faults.size(), "fault")));
  }
  if (const std::string warning = data_warning(tables); !warning.empty()) {
    warnings.push_back(warning);
  }
  if (tables.set.methods.size() < 2) {
    warnings.emplace_back("The protocol has one method: there is no comparison.");
  }
  if (tables.set.participants.size() < 2) {
    warnings.emplace_back("One participant: no standard deviations and no intervals.");
  }
  for (const MethodComparison& row : output.comparisons.methods) {
    if (row.planned && !row.missing.empty()) {
      warnings.push_back(fmt::format(
          "The planned comparison of {} and {} in {} has no P-value ({}); Holm's adjustment counts "
          "it as not significant.",
          row.method, row.reference, row.measure, row.missing));
    } else if (row.planned) {
      const PrimaryResult& primary = *row.primary;
      for (const auto& [verb, what] : {std::pair("is by", primary.instead),
                                       std::pair("has a warning of R for", primary.warning)}) {
        if (!what.empty()) {
          warnings.push_back(fmt::format("The planned comparison of {} and {} in {} {} the {}: {}.",
                                         row.method, row.reference, row.measure, verb,
                                         name_of(primary.kind), what));
        }
      }
    }
  }
  if (const std::string few = few_scenes(output.comparisons, tables.set.scenes.size());
      !few.empty()) {
    warnings.push_back(few);
  }
  for (const DataQualityCheck& check : output.checks.checks) {
    if (check.verdict == Verdict::flagged && check.value_text != data_warning(tables)) {
      warnings.push_back(
          fmt::format("A data-quality limit was missed: {}: {}.", check.name, check.value_text));
    }
  }
  if (const std::size_t count = tables.amended.size(); count > 0) {
    warnings.push_back(fmt::format(
        "{} an amended protocol: amended_sessions.csv names them and the changed keys.",
        count == 1 ? "One session followed" : fmt::format("{} sessions followed", count)));
  }
  if (const std::size_t count = tables.set.exclusions.size(); count > 0) {
    warnings.push_back(fmt::format(
        "{} left out: exclusions.csv names them with the reasons.",
        count == 1 ? "One session or value is" : fmt::format("{} sessions or values are", count)));
  }
  return warnings;
}

}  // namespace foveola::analysis
