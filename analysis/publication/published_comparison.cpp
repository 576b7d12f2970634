#include "analysis/publication/published_comparison.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "analysis/publication/output_folder.h"
#include "analysis/publication/wording.h"
#include "renderer/base/csv.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

std::optional<Interval> exactly(std::optional<double> value) {
  return value ? std::optional(Interval{*value, *value}) : std::nullopt;
}

/// The answers that the analysed participants gave to a question.
Description answers_to(const StudyTables& tables, const std::vector<study::BackgroundRow>& answers,
                       const std::string& question) {
  const std::set<std::string> analysed(tables.set.participants.begin(),
                                       tables.set.participants.end());
  std::vector<double> values;
  for (const study::BackgroundRow& row : answers) {
    if (row.question == question && analysed.contains(row.participant)) {
      values.push_back(row.value);
    }
  }
  return describe(values);
}

void compare_background(const StudyTables& tables, const std::vector<study::BackgroundRow>& answers,
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
std::optional<std::size_t> scene_of(const AnalysisSet& set, const PublishedTime& row) {
  for (const std::string& name : {row.scene, row.counterpart}) {
    const auto found = std::find(set.scenes.begin(), set.scenes.end(), name);
    if (found != set.scenes.end()) {
      return static_cast<std::size_t>(found - set.scenes.begin());
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> method_position(const AnalysisSet& set, const std::string& method) {
  const auto found = std::find(set.methods.begin(), set.methods.end(), method);
  return found == set.methods.end()
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(found - set.methods.begin()));
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
    const SceneTimes times =
        has_study ? tables.scene_times_of(row.mark, *scene, *method) : SceneTimes{};
    for (const StudyNumbers& numbers : readings_of(times, is_baseline)) {
      const ComparedCell cell{.source = "Table 2",
                              .row = row.scene,
                              .own_row = scene ? tables.set.scenes[*scene] : "",
                              .mark = std::string(name_of(row.mark)),
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
    for (const Mark mark : marks) {
      ComparedCell cell{.source = "text",
                        .row = "all scenes",
                        .own_row = "all scenes",
                        .mark = std::string(name_of(mark)),
                        .method = range.method,
                        .quantity = "mean",
                        .reading = "geometric mean",
                        .unit = "%",
                        .published = range.percent_of_od,
                        .study = std::nullopt};
      if (method && *method != baseline && tables.set.methods.front() == "od") {
        const auto& estimate = tables.method_times_of(mark, *method).percent_of_baseline;
        cell.study = estimate ? std::optional(estimate->value) : std::nullopt;
      }
      cells.push_back(std::move(cell));
    }
  }
}

/// The study's records compared with everything that is known of the published study.
struct Comparison {
  StudyTables tables;
  std::vector<ComparedCell> cells;
};

Comparison compare_study(const fs::path& database) {
  const fs::path folder = resource_folder() / "data" / "koskela2018";
  const PublishedTables published = read_published_tables(folder);
  const std::vector<PublishedMean> means = read_published_means(folder / "mean_percent_of_od.csv");
  const study::StudyRecords records = study::read_study(database);
  Comparison comparison{tabulate_study(records), {}};
  comparison.cells =
      compare_with_published(comparison.tables, records.background, published, means);
  return comparison;
}

std::string comparison_summary(const Comparison& comparison) {
  std::string text;
  std::size_t unknown = 0;
  for (const ComparedCell& cell : comparison.cells) {
    unknown += cell.published ? 0 : 1;
    if (cell.source == "text") {
      text += fmt::format(
          "{} until the {}, over all scenes: {} % of OD's time; published {:g} to "
          "{:g} %\n",
          method_label(cell.method), cell.mark, fixed(cell.study, 1), cell.published->low,
          cell.published->high);
    }
  }
  if (unknown > 0) {
    text += fmt::format("{} cells of the published Tables 1 and 2 are not at hand.\n", unknown);
  }
  return text;
}

}  // namespace

std::vector<ComparedCell> compare_with_published(const StudyTables& tables,
                                                 const std::vector<study::BackgroundRow>& answers,
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

std::string report_published_comparison(const fs::path& database, const fs::path& folder) {
  const Comparison comparison = compare_study(database);
  const std::string table = comparison_csv(comparison.tables, comparison.cells);
  const std::string page = comparison_html(comparison.tables, comparison.cells);
  make_output_folder(folder);
  write_file(folder / "published_comparison.csv", table);
  write_file(folder / "published_comparison.html", page);
  return comparison_summary(comparison) +
         fmt::format("Compared with the published study in {}\n",
                     (folder / "published_comparison.html").string());
}

}  // namespace foveola::analysis
