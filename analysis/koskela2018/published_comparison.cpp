#include "analysis/koskela2018/published_comparison.h"

#include <algorithm>
#include <set>

namespace foveola::analysis {
namespace {

std::optional<Interval> exactly(std::optional<double> value) {
  return value ? std::optional(Interval{*value, *value}) : std::nullopt;
}

/// The answers that the analysed participants gave to a question.
Description answers_to(const StudyTables& tables, const std::vector<BackgroundAnswer>& answers,
                       const std::string& question) {
  const std::set<std::string> analysed(tables.set.participants.begin(),
                                       tables.set.participants.end());
  std::vector<double> values;
  for (const BackgroundAnswer& row : answers) {
    if (row.question == question && analysed.contains(row.participant)) {
      values.push_back(row.value);
    }
  }
  return describe(values);
}

void compare_background(const StudyTables& tables, const std::vector<BackgroundAnswer>& answers,
                        const PublishedTables& published, std::vector<ComparedCell>& cells) {
  for (const PublishedBackground& row : published.background) {
    const Description given = answers_to(tables, answers, row.question);
    const ComparedCell cell{.source = "Table 1",
                            .row = row.question,
                            .own_row = given.n > 0 ? row.question : "",
                            .mark = "",
                            .method = "",
                            .quantity = "mean",
                            .reading = "",
                            .unit = row.question == "age" ? "years" : "points",
                            .published = exactly(row.mean),
                            .study = given.mean};
    cells.push_back(cell);
    cells.push_back(cell);
    cells.back().quantity = "sd";
    cells.back().published = exactly(row.standard_deviation);
    cells.back().study = given.standard_deviation;
  }
}

/// The study's scene that is compared with a published one.
std::optional<std::size_t> scene_of(const Dataset& set, const PublishedTime& row) {
  for (const std::string& name : {row.scene, row.counterpart}) {
    const auto found = std::find(set.scenes.begin(), set.scenes.end(), name);
    if (found != set.scenes.end()) {
      return static_cast<std::size_t>(found - set.scenes.begin());
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> method_position(const Dataset& set, const std::string& method) {
  const auto found = std::find(set.methods.begin(), set.methods.end(), method);
  return found == set.methods.end()
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(found - set.methods.begin()));
}

/// The index of the study's mark of this id; empty if it has none.
std::optional<std::size_t> time_named(const Dataset& set, const std::string& mark) {
  const auto found = set.measure_named(mark);
  return found && set.measures[*found].kind == MeasureKind::time ? found : std::nullopt;
}

/// This study's mean and deviation in one reading of Table 2.
struct StudyNumbers {
  std::string reading;
  std::optional<double> mean;
  std::optional<double> standard_deviation;
};

/// The cells of one published time: one for the baseline's seconds, two readings of the others'
/// percentages.
std::vector<StudyNumbers> readings_of(const SceneTimes& times, bool is_baseline) {
  if (is_baseline) {
    return {{"", times.seconds.mean, times.seconds.standard_deviation}};
  }
  return {
      {"own ratios", times.percent_of_baseline.mean, times.percent_of_baseline.standard_deviation},
      {"ratio of means", times.of_baseline_mean.mean_percent,
       times.of_baseline_mean.sd_percent_points}};
}

void compare_times(const StudyTables& tables, const PublishedTables& published,
                   std::vector<ComparedCell>& cells) {
  const bool same_baseline = tables.set.methods.front() == "od";
  for (const PublishedTime& row : published.times) {
    const bool is_baseline = row.method == "od";
    const auto scene = scene_of(tables.set, row);
    const auto method = method_position(tables.set, row.method);
    const bool has_study = scene && method && same_baseline;
    const auto mark = time_named(tables.set, row.mark);
    const SceneTimes times =
        has_study && mark ? tables.scene_times_of(*mark, *scene, *method) : SceneTimes{};
    for (const StudyNumbers& numbers : readings_of(times, is_baseline)) {
      const ComparedCell cell{.source = "Table 2",
                              .row = row.scene,
                              .own_row = scene ? tables.set.scenes[*scene] : "",
                              .mark = row.mark,
                              .method = row.method,
                              .quantity = "mean",
                              .reading = numbers.reading,
                              .unit = is_baseline ? "s" : "%",
                              .published = exactly(row.mean),
                              .study = numbers.mean};
      cells.push_back(cell);
      cells.push_back(cell);
      cells.back().quantity = "sd";
      cells.back().unit = is_baseline ? "s" : "percentage points";
      cells.back().published = exactly(row.standard_deviation);
      cells.back().study = numbers.standard_deviation;
    }
  }
}

void compare_ranges(const StudyTables& tables, const std::vector<PublishedMean>& means,
                    std::vector<ComparedCell>& cells) {
  for (const PublishedMean& range : means) {
    const auto method = method_position(tables.set, range.method);
    for (const std::string mark : {"outline", "material"}) {
      const auto time = time_named(tables.set, mark);
      ComparedCell cell{.source = "text",
                        .row = "all scenes",
                        .own_row = "all scenes",
                        .mark = mark,
                        .method = range.method,
                        .quantity = "mean",
                        .reading = "geometric mean",
                        .unit = "%",
                        .published = range.percent_of_od,
                        .study = std::nullopt};
      if (time && method && *method != baseline && tables.set.methods.front() == "od") {
        const auto& estimate = tables.method_times_of(*time, *method).percent_of_baseline;
        cell.study = estimate ? std::optional(estimate->value) : std::nullopt;
      }
      cells.push_back(std::move(cell));
    }
  }
}

}  // namespace

std::vector<ComparedCell> compare_with_published(const StudyTables& tables,
                                                 const std::vector<BackgroundAnswer>& answers,
                                                 const PublishedTables& published,
                                                 const std::vector<PublishedMean>& means) {
  std::vector<ComparedCell> cells;
  compare_background(tables, answers, published, cells);
  compare_times(tables, published, cells);
  compare_ranges(tables, means, cells);
  return cells;
}

std::optional<double> difference_of(const ComparedCell& cell) {
  if (!cell.published || !cell.study) {
    return std::nullopt;
  }
  return *cell.study - std::clamp(*cell.study, cell.published->low, cell.published->high);
}

std::string what_is_missing(const ComparedCell& cell) {
  if (!cell.published && !cell.study) {
    return "the published number is not at hand, and this study has none";
  }
  if (!cell.published) {
    return "the published number is not at hand";
  }
  return cell.study ? "" : "this study has no such number";
}

}  // namespace foveola::analysis
