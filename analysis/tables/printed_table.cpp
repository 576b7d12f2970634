#include "analysis/tables/printed_table.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/tables/html.h"
#include "analysis/tables/latex.h"
#include "renderer/base/numbers/aligned_rows.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

std::string heading_cells(const PrintedTable& table) {
  std::string cells;
  for (const std::string& column : table.columns) {
    cells += fmt::format("<th scope=\"col\">{}</th>", escape_html(column));
  }
  return cells;
}

std::string group_cells(const PrintedTable& table) {
  std::string cells;
  for (const ColumnGroup& group : table.groups) {
    cells += group.heading.empty() ? std::string("<td></td>")
                                   : fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>",
                                                 group.columns, escape_html(group.heading));
  }
  return cells;
}

std::string body_cells(const std::vector<std::string>& row) {
  std::string cells = fmt::format("<th scope=\"row\">{}</th>", escape_html(row.at(0)));
  for (std::size_t i = 1; i < row.size(); ++i) {
    cells += fmt::format("<td>{}</td>", escape_html(row[i]));
  }
  return cells;
}

std::string latex_row(const std::vector<std::string>& cells) {
  const std::vector<std::string> texts =
      transformed(cells, [&](const std::string& cell) { return latex_text(cell); });
  // After the end of a row, LaTeX would take these for its arguments.
  const bool is_argument = texts.at(0).starts_with('[') || texts.at(0).starts_with('*');
  return fmt::format("{}{} \\\\\n", is_argument ? "{}" : "", fmt::join(texts, " & "));
}

/// Returns whether a column has texts that are better broken into lines, and can be.
bool has_long_texts(const PrintedTable& table, std::size_t column) {
  constexpr std::size_t longest_in_one_line = 30;
  return std::ranges::any_of(table.rows, [&](const auto& row) {
    return count_characters(row.at(column)) > longest_in_one_line &&
           row.at(column).find_first_of(" -_/") != std::string::npos;
  });
}

std::string latex_columns(const PrintedTable& table) {
  std::string columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    columns += has_long_texts(table, i)    ? ">{\\raggedright\\arraybackslash}p{14em}"
               : table.is_numeric && i > 0 ? "r"
                                           : "l";
  }
  return columns;
}

std::string latex_caption(const PrintedTable& table, std::string_view notice) {
  std::string caption;
  if (!notice.empty()) {
    caption = fmt::format("\\textbf{{{}.}} ", latex_text(notice));
  }
  caption += latex_text(table.title);
  if (!table.note.empty()) {
    caption += ' ';
    caption += latex_text(table.note);
  }
  return caption;
}

std::string latex_groups(const PrintedTable& table) {
  const std::vector<std::string> cells = transformed(table.groups, [&](const ColumnGroup& group) {
    return fmt::format("\\multicolumn{{{}}}{{c}}{{{}}}", group.columns, latex_text(group.heading));
  });
  return cells.empty() ? "" : fmt::format("{} \\\\\n", fmt::join(cells, " & "));
}

}  // namespace

std::string html_of(const PrintedTable& table, std::string_view notice) {
  if (table.rows.empty()) {
    return "";
  }
  std::string html = fmt::format(
      "<div class=\"scroll\" role=\"group\" aria-label=\"Table\" "
      "tabindex=\"0\"><table{}>\n<caption>{}{}</caption>\n<thead>",
      table.is_numeric ? " class=\"numeric\"" : "", caption_html(table.title, notice),
      escape_html(table.note));
  if (!table.groups.empty()) {
    html += "<tr>" + group_cells(table) + "</tr>\n";
  }
  html += "<tr>" + heading_cells(table) + "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    html += "<tr>" + body_cells(row) + "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string latex_of(const PrintedTable& table, std::string_view notice) {
  std::string text = fmt::format(
      "\\begin{{table}}\n\\centering\n\\caption{{{}}}\n\\label{{tab:{}}}\n"
      "\\resizebox{{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}}{{!}}{{%\n"
      "\\begin{{tabular}}{{{}}}\n\\toprule\n{}{}\\midrule\n",
      latex_caption(table, notice), table.id, latex_columns(table), latex_groups(table),
      latex_row(table.columns));
  for (const std::vector<std::string>& row : table.rows) {
    text += latex_row(row);
  }
  text += "\\bottomrule\n\\end{tabular}}\n\\end{table}\n";
  return latex_needs(text) + text;
}

std::string plain_text_of(const PrintedTable& table, std::string_view notice) {
  std::string title = printable(table.title);
  if (title.ends_with('.')) {
    title.pop_back();
  }
  std::vector<TextRow> rows = {table.columns};
  rows.insert(rows.end(), table.rows.begin(), table.rows.end());
  return fmt::format(
      "{}{}\n{}{}", title, notice.empty() ? "" : fmt::format(" ({})", notice),
      aligned(rows, {.indent = 2, .gap = 3, .numbers_to_the_right = table.is_numeric}),
      table.note.empty() ? "" : fmt::format("  {}\n", printable(table.note)));
}

}  // namespace foveola::analysis
