#include "analysis/publication/analysis_plan.h"

#include <algorithm>

#include "renderer/base/toml_reader.h"
#include "study/protocol/analysed_measures.h"

namespace foveola::analysis {
namespace {

/// The first of the protocol's methods, with which those are compared that name no other.
std::string first_method(TomlReader& protocol) {
  const std::vector<TomlReader::Text> methods = protocol.texts("methods");
  return methods.empty() ? "" : methods.front().value;
}

void read_margin(TomlReader& margins, const char* measure, study::AnalysisPlan& plan) {
  double margin = 0.0;
  margins.read(measure, margin, 0.001, 100.0);
  if (margins.has(measure)) {
    plan.equivalence_margins[measure] = margin;
  }
}

}  // namespace

study::AnalysisPlan plan_of(const std::string& protocol_text) {
  const std::string file = "the study's protocol";
  const toml::table toml = parse_toml(file, protocol_text, "restore the study's file");
  TomlReader protocol(file, toml, "");
  TomlReader analysis = protocol.table("analysis");
  study::AnalysisPlan plan;
  analysis.read("alpha", plan.alpha, 1e-6, 0.5);
  int participants = 1;
  analysis.read("participants", participants, 1, 100'000);
  if (analysis.has("participants")) {
    plan.participants = participants;
  }
  const std::string reference = first_method(protocol);
  for (TomlReader entry : analysis.tables("primary")) {
    study::PlannedComparison comparison{.measure = entry.require_text("measure"),
                                        .method = entry.require_text("method"),
                                        .baseline = reference};
    entry.read("baseline", comparison.baseline);
    plan.primary.push_back(comparison);
  }
  TomlReader margins = analysis.table("equivalence_margins");
  for (const char* measure : {"outline", "material", "artifacts"}) {
    read_margin(margins, measure, plan);
  }
  return plan;
}

bool is_primary(const study::AnalysisPlan& plan, const std::string& measure,
                const std::string& method, const std::string& reference) {
  return std::any_of(plan.primary.begin(), plan.primary.end(), [&](const auto& planned) {
    return planned.measure == measure && planned.method == method && planned.baseline == reference;
  });
}

std::size_t planned_without_tables(const study::AnalysisPlan& plan) {
  const auto is_compared = [](const std::string& measure) {
    return measure == study::analysed_rating ||
           std::find(study::analysed_marks.begin(), study::analysed_marks.end(), measure) !=
               study::analysed_marks.end();
  };
  return static_cast<std::size_t>(
      std::count_if(plan.primary.begin(), plan.primary.end(),
                    [&](const auto& planned) { return !is_compared(planned.measure); }));
}

std::optional<double> equivalence_margin(const study::AnalysisPlan& plan,
                                         const std::string& measure) {
  const auto found = plan.equivalence_margins.find(measure);
  return found == plan.equivalence_margins.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace foveola::analysis
