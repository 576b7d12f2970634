#include <fmt/format.h>

#include "analysis/publication/html.h"
#include "analysis/publication/published_comparison.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/wording.h"
#include "renderer/base/csv.h"

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
  HtmlTable table;
  table.caption_html = caption_start(tables, title) + escape_html(explanation);
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
  return table.rows.empty() ? "" : render(table);
}

}  // namespace

std::string comparison_csv(const StudyTables& tables, const std::vector<ComparedCell>& cells) {
  std::vector<CsvRow> rows = {{"source", "row", "own_row", "mark", "method", "quantity", "reading",
                               "unit", "published_low", "published_high", "study", "difference",
                               "missing", "participant_kind"}};
  for (const ComparedCell& cell : cells) {
    rows.push_back({cell.source, cell.row, cell.own_row, cell.mark, cell.method, cell.quantity,
                    cell.reading, cell.unit, cell.published ? csv_number(cell.published->low) : "",
                    cell.published ? csv_number(cell.published->high) : "", csv_number(cell.study),
                    csv_number(difference_of(cell)), what_is_missing(cell), tables.set.kind});
  }
  return format_csv(rows);
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

}  // namespace foveola::analysis
