#include "analysis/publication/published_comparison_report.h"

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/output_folder.h"
#include "analysis/publication/report_parts.h"
#include "analysis/tables/printed_table.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

std::string published_in_words(const ComparedCell& cell) {
  if (!cell.published) {
    return "not at hand";
  }
  return cell.published->low == cell.published->high
             ? fmt::format("{:g}", cell.published->low)
             : fmt::format("{:g}–{:g}", cell.published->low, cell.published->high);
}

/// The cells of one source as a table.
std::string table_of(const StudyTables& tables, const std::vector<ComparedCell>& cells,
                     const std::string& source, const std::string& title,
                     const std::string& explanation) {
  PrintedTable table;
  table.title = title;
  table.note = explanation;
  table.columns = {"Published", "This study’s",    "Mark",       "Method",    "Quantity",
                   "Reading",   "Published value", "This study", "Difference"};
  const auto or_dash = [](const std::string& text) { return text.empty() ? "–" : text; };
  for (const ComparedCell& cell : cells) {
    if (cell.source == source) {
      table.rows.push_back({cell.row, or_dash(cell.own_row), or_dash(cell.mark),
                            or_dash(cell.method.empty() ? "" : method_label(cell.method)),
                            fmt::format("{}, {}", cell.quantity, cell.unit), or_dash(cell.reading),
                            published_in_words(cell), fixed(cell.study, 2),
                            fixed(difference_of(cell), 2)});
    }
  }
  return html_of(table, data_notice(tables));
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
      compare_with_published(comparison.tables, background_answers(records), published, means);
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

Table published_comparison_table(const StudyTables& tables,
                                 const std::vector<ComparedCell>& cells) {
  using Cell = ComparedCell;
  using enum ColumnType;
  const ColumnsOf<Cell> columns = {
      {{"source", text, "", "Table 1 or 2 of the paper, or its text"},
       [](const Cell& cell) { return field(cell.source); }},
      {{"row", text, "", "The paper's question or scene"},
       [](const Cell& cell) { return field(cell.row); }},
      {{"own_row", text, "", "This study's question or scene that is compared"},
       [](const Cell& cell) { return field(cell.own_row); }},
      {{"mark", text, "", "Id of the mark"}, [](const Cell& cell) { return field(cell.mark); }},
      {{"method", text, "", "Id of the method"},
       [](const Cell& cell) { return field(cell.method); }},
      {{"quantity", text, "", "mean or sd"}, [](const Cell& cell) { return field(cell.quantity); }},
      {{"reading", text, "", "How the percentage was formed"},
       [](const Cell& cell) { return field(cell.reading); }},
      {{"unit", text, "", "Unit of the values"}, [](const Cell& cell) { return field(cell.unit); }},
      {{"published_low", number, "", "Published number, or the lower end of its range"},
       [](const Cell& cell) {
         return field_in(cell.published, [](const Interval& range) { return range.low; });
       }},
      {{"published_high", number, "", "Published number, or the upper end of its range"},
       [](const Cell& cell) {
         return field_in(cell.published, [](const Interval& range) { return range.high; });
       }},
      {{"study", number, "", "This study's number"},
       [](const Cell& cell) { return field(cell.study); }},
      {{"difference", number, "", "This study's number less the nearer end of the range"},
       [](const Cell& cell) { return field(difference_of(cell)); }},
      {{"missing", text, "", "Why there is no difference"},
       [](const Cell& cell) { return field(what_is_missing(cell)); }},
      {{"participant_kind", text, "", "Who took part: human, pilot or simulated"},
       [&](const Cell& /*cell*/) { return field(tables.set.kind); }}};
  return tabulate("published_comparison", "number of the paper", columns, cells);
}

std::string comparison_html(const StudyTables& tables, const std::vector<ComparedCell>& cells) {
  const std::string intro =
      "<p>Every number of the published Tables 1 and 2 beside this study’s. “Not at hand” is a "
      "number of the paper’s that Foveola’s data do not hold; none is made up. The paper does not "
      "say how its percentages and percentage points were formed, so each stands in two readings: "
      "the mean and deviation of each participant’s own ratio, and the ratio of means with the "
      "deviation over OD’s mean. Neither is claimed to be the published one.</p>\n";
  const std::string content =
      intro +
      table_of(tables, cells, "text", "Over all scenes.",
               "The published range of mean times in per cent of OD’s, and this study’s geometric "
               "mean; the difference is how far it lies outside the range.") +
      table_of(tables, cells, "Table 2", "Table 2: times in each scene.",
               "A published scene that this study does not show is compared with Foveola’s own "
               "counterpart of it, which is another scene.") +
      table_of(tables, cells, "Table 1", "Table 1: background.",
               "Means and deviations over participants.");
  return report_page(tables, "Beside the published study", content);
}

std::string report_published_comparison(const fs::path& database, const fs::path& folder) {
  const Comparison comparison = compare_study(database);
  const std::string table = csv_of(published_comparison_table(comparison.tables, comparison.cells));
  const std::string page = comparison_html(comparison.tables, comparison.cells);
  make_output_folder(folder);
  write_file(folder / "published_comparison.csv", table);
  write_file(folder / "published_comparison.html", page);
  return comparison_summary(comparison) +
         fmt::format("Compared with the published study in {}\n",
                     (folder / "published_comparison.html").string());
}

}  // namespace foveola::analysis
