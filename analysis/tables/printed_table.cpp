#include "analysis/tables/printed_table.h"

#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/tables/html.h"
#include "renderer/base/aligned_rows.h"
#include "renderer/base/utf8.h"

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

/// The whole text as a number; empty if it is none, or too large.
template <typename Number>
std::optional<Number> number_in_full(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, number);
  return failure == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// A number with an exponent, as 3.3e-05, or "< 1e-300", as a power of ten; empty for another text.
std::optional<std::string> power_of_ten(std::string_view text) {
  const std::size_t e = text.find('e');
  if (e == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view factor = text.substr(0, e);
  std::string_view exponent = text.substr(e + 1);
  exponent.remove_prefix(exponent.starts_with('+') ? 1 : 0);
  const std::optional<int> power = number_in_full<int>(exponent);
  if (!power || (factor != "< 1" && !number_in_full<double>(factor))) {
    return std::nullopt;
  }
  return factor == "< 1" ? fmt::format("$< 10^{{{}}}$", *power)
                         : fmt::format("${} \\times 10^{{{}}}$", factor, *power);
}

/// The symbols of statistics that a typesetter has in its own way; empty for any other.
std::string_view latex_symbol(std::string_view rest, std::size_t& bytes) {
  struct Symbol {
    std::string_view text;
    std::string_view latex;
  };
  constexpr Symbol symbols[] = {{"±", "$\\pm$"},      {"–", "--"},      {"−", "$-$"},
                                {"×", "$\\times$"},   {"²", "$^2$"},    {"η", "$\\eta$"},
                                {"ε", "$\\epsilon$"}, {"χ", "$\\chi$"}, {"ρ", "$\\rho$"},
                                {"°", "$^\\circ$"},   {"’", "'"},       {"“", "``"},
                                {"”", "''"},          {"…", "\\dots{}"}};
  for (const Symbol& symbol : symbols) {
    if (rest.starts_with(symbol.text)) {
      bytes = symbol.text.size();
      return symbol.latex;
    }
  }
  return {};
}

std::string latex_row(const std::vector<std::string>& cells) {
  std::vector<std::string> texts;
  for (const std::string& cell : cells) {
    texts.push_back(latex_text(cell));
  }
  return fmt::format("{} \\\\\n", fmt::join(texts, " & "));
}

std::string latex_groups(const PrintedTable& table) {
  std::vector<std::string> cells;
  for (const ColumnGroup& group : table.groups) {
    cells.push_back(
        fmt::format("\\multicolumn{{{}}}{{c}}{{{}}}", group.columns, latex_text(group.heading)));
  }
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
      "% Needs \\usepackage{{booktabs}}.\n\\begin{{table}}\n\\centering\n\\caption{{{}{}{}}}\n"
      "\\label{{tab:{}}}\n\\begin{{tabular}}{{l{}}}\n\\toprule\n{}{}\\midrule\n",
      notice.empty() ? "" : "\\textbf{" + latex_text(notice) + ".} ", latex_text(table.title),
      table.note.empty() ? "" : " " + latex_text(table.note), table.id,
      std::string(table.columns.size() - 1, table.is_numeric ? 'r' : 'l'), latex_groups(table),
      latex_row(table.columns));
  for (const std::vector<std::string>& row : table.rows) {
    text += latex_row(row);
  }
  return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
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

std::string latex_text(std::string_view text) {
  if (const std::optional<std::string> power = power_of_ten(text)) {
    return *power;
  }
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    std::size_t bytes = 0;
    if (const std::string_view symbol = latex_symbol(text.substr(i), bytes); bytes > 0) {
      escaped += symbol;
      i += bytes - 1;
    } else if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) {
      escaped += '\\';
      escaped += c;
    } else if (c == '\\') {
      escaped += "\\textbackslash{}";
    } else if (c == '<' || c == '>' || c == '|') {
      escaped += c == '<' ? "\\textless{}" : c == '>' ? "\\textgreater{}" : "\\textbar{}";
    } else if (c == '"') {
      escaped += "''";  // a command of its own in several languages' packages
    } else if (c == '~' || c == '^') {
      escaped += fmt::format("\\{}{{}}", c);
    } else {
      escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

}  // namespace foveola::analysis
