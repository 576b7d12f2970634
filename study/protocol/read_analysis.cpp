#include "study/protocol/read_analysis.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "study/protocol/read_settings.h"

namespace foveola::study {
namespace {

/// A mark or a rating in numbers, and the equivalence margins that it can have.
struct Measure {
  std::string id;
  double smallest_margin = 0.0;
  double largest_margin = 0.0;
};

std::vector<Measure> measures_of(const Protocol& protocol) {
  std::vector<Measure> measures;
  for (const MarkEntry& mark : protocol.marks) {
    measures.push_back({mark.id, 1.001, 100.0});
  }
  for (const Question& rating : protocol.ratings) {
    if (rating.kind == QuestionKind::likert || rating.kind == QuestionKind::number) {
      measures.push_back({rating.id, 0.001, rating.maximum - rating.minimum});
    }
  }
  return measures;
}

std::string read_measure(TomlReader& reader, const std::vector<Measure>& measures) {
  const std::string id = reader.require_text("measure");
  std::vector<std::string> known;
  for (const Measure& measure : measures) {
    known.push_back(measure.id);
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

std::vector<PlannedComparison> read_comparisons(TomlReader& reader, const Protocol& protocol) {
  const std::vector<Measure> measures = measures_of(protocol);
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
  for (const Measure& measure : measures_of(protocol)) {
    double margin = 0.0;
    reader.read(measure.id, margin, measure.smallest_margin, measure.largest_margin);
    if (reader.has(measure.id)) {
      margins[measure.id] = margin;
    }
  }
  reader.reject_unknown_keys();
  return margins;
}

}  // namespace

AnalysisPlan read_analysis(TomlReader reader, const Protocol& protocol) {
  AnalysisPlan plan;
  reader.read("alpha", plan.alpha, 1e-6, 0.5);
  int participants = 1;
  reader.read("participants", participants, 1, 100'000);
  if (reader.has("participants")) {
    plan.participants = participants;
  }
  plan.primary = read_comparisons(reader, protocol);
  plan.equivalence_margins = read_margins(reader.table("equivalence_margins"), protocol);
  reader.reject_unknown_keys();
  return plan;
}

}  // namespace foveola::study
