#include "study/protocol/read_analysis.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "study/protocol/measure.h"
#include "study/protocol/read_settings.h"

namespace foveola::study {
namespace {

constexpr std::array scene_effects{Word<SceneEffects>{"random", SceneEffects::random},
                                   Word<SceneEffects>{"fixed", SceneEffects::fixed}};
constexpr std::array rating_analyses{
    Word<RatingAnalysis>{"ordinal_model", RatingAnalysis::ordinal_model},
    Word<RatingAnalysis>{"signed_ranks", RatingAnalysis::signed_ranks}};

std::vector<Measure> comparable_measures(const Protocol& protocol) {
  std::vector<Measure> measures = trial_measures(protocol.marks, protocol.ratings);
  std::erase_if(measures, [](const Measure& measure) { return !measure.is_numeric(); });
  return measures;
}

/// The largest difference that could be called small: a factor of times, or a range of values.
double largest_margin(const Measure& measure) {
  if (measure.kind == MeasureKind::time) {
    return 100.0;
  }
  const std::vector<double> points = measure.points();
  if (measure.question.kind != QuestionKind::choice || points.empty()) {
    return measure.question.maximum - measure.question.minimum;
  }
  const auto [low, high] = std::minmax_element(points.begin(), points.end());
  return *high - *low;
}

std::string read_measure(TomlReader& reader, const std::vector<Measure>& measures) {
  const std::string id = reader.require_text("measure");
  std::vector<std::string> known;
  for (const Measure& measure : measures) {
    known.push_back(measure.id());
  }
  if (std::find(known.begin(), known.end(), id) == known.end()) {
    reader.fail(reader.source("measure"),
                fmt::format("no mark and no rating in numbers has the id '{}'", id),
                fmt::format("choose one of {}", fmt::join(known, ", ")));
  }
  return id;
}

PlannedComparison read_comparison(TomlReader reader, const Protocol& protocol,
                                  const std::vector<Measure>& measures) {
  PlannedComparison comparison{.measure = read_measure(reader, measures)};
  reader.require("method");
  comparison.method = read_method_name(reader, "method", protocol);
  comparison.baseline = read_method_name(reader, "baseline", protocol);
  if (!reader.has("baseline")) {
    comparison.baseline = protocol.methods.front();
  }
  reader.reject_unknown_keys();
  if (comparison.method == comparison.baseline) {
    reader.fail(reader.source("method"),
                fmt::format("'{}' would be compared with itself", comparison.method),
                "choose another method or baseline");
  }
  return comparison;
}

/// In either direction: its P-value is the same, and the family of planned tests would have it
/// twice.
bool is_same(const PlannedComparison& a, const PlannedComparison& b) {
  return a.measure == b.measure &&
         std::minmax(a.method, a.baseline) == std::minmax(b.method, b.baseline);
}

PlannedComparison reversed(const PlannedComparison& comparison) {
  return {
      .measure = comparison.measure, .method = comparison.baseline, .baseline = comparison.method};
}

std::vector<PlannedComparison> read_comparisons(TomlReader& reader, const Protocol& protocol) {
  const std::vector<Measure> measures = comparable_measures(protocol);
  std::vector<PlannedComparison> comparisons;
  for (const TomlReader& entry : reader.tables("primary")) {
    const PlannedComparison next = read_comparison(entry, protocol, measures);
    if (std::any_of(comparisons.begin(), comparisons.end(),
                    [&](const PlannedComparison& other) { return is_same(other, next); })) {
      entry.fail(entry.source(), "this comparison is planned twice", "leave one out");
    }
    comparisons.push_back(next);
  }
  return comparisons;
}

std::map<std::string, double> read_margins(TomlReader reader, const Protocol& protocol) {
  std::map<std::string, double> margins;
  for (const Measure& measure : comparable_measures(protocol)) {
    const double smallest = measure.kind == MeasureKind::time ? 1.001 : 0.001;
    std::optional<double> margin;
    reader.read(measure.id(), margin, smallest, largest_margin(measure));
    if (margin) {
      margins[measure.id()] = *margin;
    }
  }
  reader.reject_unknown_keys();
  return margins;
}

bool is_in_numbers(const Question& question) {
  return question.kind == QuestionKind::likert || question.kind == QuestionKind::number;
}

std::vector<std::string> read_background(TomlReader& reader, const Protocol& protocol) {
  std::vector<std::string> known;
  for (const Questionnaire& form : protocol.questionnaires) {
    if (form.id == "background") {
      for (const Question& question : form.questions) {
        if (is_in_numbers(question)) {
          known.push_back(question.id);
        }
      }
    }
  }
  std::vector<std::string> scale;
  for (const TomlReader::Text& id : reader.texts("background")) {
    if (std::find(known.begin(), known.end(), id.value) == known.end()) {
      reader.fail(
          id.source,
          fmt::format("the questionnaire background has no question '{}' in numbers", id.value),
          known.empty() ? "leave the key out"
                        : fmt::format("choose from {}", fmt::join(known, ", ")));
    }
    scale.push_back(id.value);
  }
  return scale;
}

}  // namespace

AnalysisPlan read_analysis(TomlReader reader, const Protocol& protocol) {
  AnalysisPlan plan;
  reader.read("alpha", plan.alpha, 1e-6, 0.5);
  reader.read("participants", plan.participants, 1, 100'000);
  reader.read("scenes", plan.scenes, scene_effects);
  reader.read("ratings", plan.ratings, rating_analyses);
  plan.background = read_background(reader, protocol);
  plan.primary = read_comparisons(reader, protocol);
  plan.equivalence_margins = read_margins(reader.table("equivalence_margins"), protocol);
  reader.reject_unknown_keys();
  return plan;
}

void require_computable(TomlReader reader, const AnalysisPlan& plan) {
  if (plan.participants == 1 && !plan.primary.empty()) {
    reader.fail(reader.source("participants"),
                "one participant cannot be tested: a comparison needs two",
                "plan more participants, or no comparison");
  }
  const std::vector<TomlReader> entries = reader.tables("primary");
  for (std::size_t i = 0; i < plan.primary.size(); ++i) {
    for (std::size_t other = 0; other < i; ++other) {
      if (is_same(plan.primary[i], reversed(plan.primary[other]))) {
        entries[i].fail(entries[i].source(),
                        "this comparison is planned already, the other way round",
                        "leave one out: a test is the same in both directions");
      }
    }
  }
}

}  // namespace foveola::study
