#include "analysis/publication/report/published_comparison_report.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/own_cells.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/publication/exports/output_folder.h"
#include "analysis/publication/report/report_parts.h"
#include "analysis/publication/tables/result_tables.h"
#include "analysis/tables/html.h"
#include "analysis/tables/printed_table.h"
#include "analysis/tables/row_text.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/files/files.h"

namespace fs = std::filesystem;
namespace foveola::analysis {
namespace {

std::string name_of_row(const PublishedScene& original, const std::string& scene) {
  return original.is_counterpart
             ? fmt::format("published: {} (counterpart: {})", original.name, scene)
             : fmt::format("published: {}", original.name);
}

std::string mean_and_deviation(const PublishedTime* time) {
  Description shown;
  if (time != nullptr) {
    shown.mean = time->mean;
    shown.standard_deviation = time->standard_deviation;
  }
  return mean_and_deviation(shown, 1);
}

/// Returns the table without columns that have no value in any row; the first column stays.
PrintedTable without_empty_columns(PrintedTable table) {
  for (std::size_t column = table.columns.size() - 1; column > 0; --column) {
    const auto is_empty = [&](const std::vector<std::string>& row) { return row[column] == "–"; };
    if (std::ranges::all_of(table.rows, is_empty)) {
      const auto at = static_cast<std::ptrdiff_t>(column);
      table.columns.erase(table.columns.begin() + at);
      for (std::vector<std::string>& row : table.rows) {
        row.erase(row.begin() + at);
      }
    }
  }
  return table;
}

/// Returns the pattern with decimals in place of each "#", as many as the paper has: Table 1 two,
/// counts in the text none, its P three, all others one.
std::vector<std::string> with_decimals(const std::string& pattern) {
  std::vector<std::string> patterns;
  for (const auto& [condition, decimals] :
       {std::pair("{source=Table 1}", "2"), std::pair("{source=text}{mark=}", "0"),
        std::pair("{source=text}{unit=}", "3"), std::pair("", "1")}) {
    patterns.push_back(condition + pattern);
    for (std::string& text = patterns.back(); text.find('#') != std::string::npos;) {
      text.replace(text.find('#'), 1, decimals);
    }
  }
  return patterns;
}

std::string table_of(const StudyTables& tables, const Table& numbers, const std::string& source,
                     const std::string& title, const std::string& explanation) {
  PrintedColumn published = {
      "Published value [95 %]",
      with_decimals("{published:.#}| [{published_ci95_low:.#}, {published_ci95_high:.#}]| {unit}")};
  // Numbers of the text are written as there.
  published.patterns.insert(published.patterns.begin(), "{source=text}{published:g}| {unit}");
  PrintedColumn study = {
      "This study [95 %]",
      with_decimals("{study:.#}| [{study_ci95_low:.#}, {study_ci95_high:.#}]| {unit}")};
  study.patterns.at(2) = "{source=text}{unit=}{study:p}";
  return table_html(tables,
                    without_empty_columns(print_rows(
                        {.title = title, .note = explanation}, numbers, "{source=" + source + "}",
                        {{"Published", "{row}"},
                         {"This study’s", "{own_row}"},
                         {"Mark", "{mark}"},
                         {"Method", "{method}"},
                         {"Reading", "{reading}"},
                         published,
                         study,
                         {"Difference", with_decimals("{difference:+.#}")},
                         {"Study over published", "{times_published:.2}"},
                         {"Study in published interval", "{study_in_published_ci95:yes/no}"},
                         {"Published in study’s interval", "{published_in_study_ci95:yes/no}"},
                         {"Published SD", with_decimals("{published_sd:.#}")},
                         {"This study’s SD", with_decimals("{study_sd:.#}")},
                         {"Difference of SDs", with_decimals("{difference_of_sds:+.#}")}})));
}

std::string counts_html(const std::vector<ComparedNumber>& numbers) {
  std::string items;
  for (const ReproducedMeans& met : count_reproduced_means(numbers)) {
    items += fmt::format("<li>{}</li>\n", escape_html(in_words(met)));
  }
  return "<ul class=\"findings\">\n" + items + "</ul>\n";
}

constexpr const char* introduction =
    "Every number of the paper’s Tables 1 and 2, and what its sections 5 to 5.2 state in numbers, "
    "beside this study’s. A published interval is ours: mean ∓ t(15)·SD/4 from the printed mean "
    "and standard deviation and the 16 participants of section 5, as if the values had been drawn "
    "from a normal distribution; nothing is cut off, so its low end may be negative where times "
    "are skewed. This study’s intervals are over participants: Student’s t for means, the delta "
    "method on the logarithm for ratios of means and for geometric means over scenes. Standard "
    "deviations have no interval. The paper does not say how its percentages and percentage "
    "points were formed, so each stands in two readings: the mean and deviation of each "
    "participant’s own ratio, and the ratio of means with the deviation over OD’s mean. Neither "
    "is claimed to be the published one.";

struct Comparison {
  StudyTables tables;
  std::vector<ComparedNumber> numbers;
};

Comparison compare_study(const fs::path& database) {
  const PublishedStudy published = read_published_study(resource_folder() / "data" / "koskela2018");
  const study::StudyRecords records = study::read_study(database);
  Comparison comparison{tabulate_study(records), {}};
  comparison.numbers = compare_with_published(records, comparison.tables, published);
  return comparison;
}

}  // namespace

Table published_comparison_table(const StudyTables& tables,
                                 const std::vector<ComparedNumber>& numbers) {
  using Number = ComparedNumber;
  const ColumnsOf<Number> columns = {
      {"source", "", "Table 1 or 2 of the paper, its geometric means over scenes, or text",
       &Number::source},
      {"section", "", "Section of the paper", &Number::section},
      {"row", "", "The paper's question or scene, or what its text states", &Number::row},
      {"own_row", "", "This study's question or scene that is compared", &Number::own_row},
      {"mark", "", "Id of the mark", &Number::mark},
      {"method", "", "Id of the method", &Number::method},
      {"reading", "", "Formula of this study's number", &Number::reading},
      {"unit", "", "Unit of the values; of deviations of percentages, percentage points",
       &Number::unit},
      {"published", "", "Number of the paper, or computed from Table 2",
       path(&Number::published, &Estimate::value)},
      {"published_ci95_low", "", "Lower 95 % confidence limit of published, computed by us",
       path(&Number::published, &Estimate::interval, &Interval::low)},
      {"published_ci95_high", "", "Upper 95 % confidence limit of published, computed by us",
       path(&Number::published, &Estimate::interval, &Interval::high)},
      {"published_sd", "", "Standard deviation in the paper", &Number::published_deviation},
      {"study", "", "This study's number", path(&Number::study, &Estimate::value)},
      {"study_ci95_low", "", "Lower 95 % confidence limit of study, over participants",
       path(&Number::study, &Estimate::interval, &Interval::low)},
      {"study_ci95_high", "", "Upper 95 % confidence limit of study, over participants",
       path(&Number::study, &Estimate::interval, &Interval::high)},
      {"study_sd", "", "This study's standard deviation", &Number::study_deviation},
      {"study_n", "", "Number of participants in this study's number",
       path(&Number::study, &Estimate::n)},
      {"difference", "", "This study's number less the published one", difference_of},
      {"times_published", "", "This study's time or factor over the published one",
       times_published},
      {"difference_of_sds", "", "This study's deviation less the published one",
       difference_of_deviations},
      {"study_in_published_ci95", "",
       "Whether study lies within the confidence limits of published",
       is_study_in_published_interval},
      {"published_in_study_ci95", "",
       "Whether published lies within the confidence limits of study",
       is_published_in_study_interval},
      kind_of_all<Number>(tables)};
  return tabulate("published_comparison", "number of the paper", columns, numbers);
}

std::string comparison_html(const StudyTables& tables, const std::vector<ComparedNumber>& numbers) {
  const Table table = with_method_labels(published_comparison_table(tables, numbers));
  const std::string content =
      paragraph_html(introduction) + counts_html(numbers) +
      table_of(tables, table, "Table 2, all scenes", "Over all scenes.",
               "Published is the geometric mean over scenes of Table 2’s means, which we compute: "
               "the paper draws its own in Fig. 5, without numbers. This study’s is formed "
               "likewise, if it has all five scenes or their counterparts; the last reading is the "
               "geometric mean over participants and all its scenes, which its report has.") +
      table_of(tables, table, "Table 2", "Table 2: times in each scene.",
               "Deviations and differences of percentages are in percentage points. A published "
               "scene that this study does not show is compared with Foveola’s own counterpart of "
               "it, which is another scene.") +
      table_of(tables, table, "Table 1", "Table 1: background.",
               "Means and standard deviations over participants.") +
      table_of(tables, table, "text", "What the text states.",
               "Of participants (section 5), of background and the time saved (5.1; it says "
               "neither of which mark, nor how times were averaged, nor which correlation P is "
               "of), and of times over all scenes (5.2: around 10 %, 10 and 3 times). What it "
               "states of the machine (5.5, 5.6), no participant’s record measures.") +
      paragraph_html(artifacts_in_order(tables));
  return report_page(tables, "Beside the published study", content);
}

std::string comparison_summary(const StudyTables& tables,
                               const std::vector<ComparedNumber>& numbers) {
  const std::string own =
      "{source=Table 2, all scenes}{reading=geometric mean}{method} until the {mark}, over all "
      "scenes: ";
  const std::string value = "{study:.1}| [{study_ci95_low:.1}, {study_ci95_high:.1}]| {unit}|";
  const std::string published =
      "; published {published:.1} {unit} (geometric mean over scenes of Table 2)\n";
  const Table table = with_method_labels(published_comparison_table(tables, numbers));
  std::string text;
  for (const Row& row : table.rows) {
    const std::string unknown = fill(own + no_value + published, table, row).value_or("");
    text += fill(own + value + published, table, row).value_or(unknown);
  }
  for (const ReproducedMeans& met : count_reproduced_means(numbers)) {
    text += in_words(met) + "\n";
  }
  const std::string artifacts = artifacts_in_order(tables);
  return text + artifacts + (artifacts.empty() ? "" : "\n");
}

std::string report_published_comparison(const fs::path& database, const fs::path& folder) {
  const Comparison comparison = compare_study(database);
  const Table table = published_comparison_table(comparison.tables, comparison.numbers);
  const std::string page = comparison_html(comparison.tables, comparison.numbers);
  make_output_folder(folder);
  write_file(folder / "published_comparison.csv", csv_of(table));
  write_file(folder / "published_comparison.json", json_of(table).dump(2) + "\n");
  write_file(folder / "published_comparison.html", page);
  return comparison_summary(comparison.tables, comparison.numbers) +
         fmt::format("Compared with the published study in {}\n",
                     (folder / "published_comparison.html").string());
}

std::optional<std::vector<std::string>> published_row(
    const StudyTables& tables, std::size_t mark, std::size_t scene,
    const std::vector<std::string>& methods, const std::optional<PublishedStudy>& published) {
  const std::string& own = tables.set.scenes[scene];
  const auto original = published && is_relative_to_od(tables.set)
                            ? published_scene_of(*published, own)
                            : std::nullopt;
  if (!original) {
    return std::nullopt;
  }
  std::vector<std::string> row = {name_of_row(*original, own)};
  for (const std::string& method : methods) {
    row.push_back(mean_and_deviation(
        published_time(*published, original->name, tables.set.measures[mark].id(), method)));
  }
  return row;
}

std::string published_rows_explained(const StudyTables& tables,
                                     const std::optional<PublishedStudy>& published) {
  const bool has_any = published && is_relative_to_od(tables.set) &&
                       std::ranges::any_of(tables.set.scenes, [&](const auto& scene) {
                         return published_scene_of(*published, scene).has_value();
                       });
  return has_any ? " Published: Table 2 of Koskela et al. 2018, section 5.2. A counterpart is "
                   "Foveola’s own scene in a published one’s place."
                 : "";
}

std::vector<std::string> published_mean_and_difference(const MethodTimes& times,
                                                       const PublishedStudy& published) {
  const auto mean = geometric_mean_of_table_2(published, times.mark, times.method);
  if (!mean) {
    return {"–", "–"};
  }
  const bool is_of_seconds = times.method == "od";
  const auto& own = is_of_seconds ? times.seconds : times.percent_of_baseline;
  return {fixed(mean, 1) + (is_of_seconds ? " s" : " %"),
          own ? with_sign(own->value - *mean, 1) + (is_of_seconds ? " s" : " points") : "–"};
}

}  // namespace foveola::analysis
