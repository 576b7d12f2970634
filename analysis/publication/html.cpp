#include "analysis/publication/html.h"

#include <fmt/format.h>

namespace foveola::analysis {
namespace {

std::string heading_cells(const HtmlTable& table) {
  std::string cells;
  for (const std::string& column : table.columns) {
    cells += fmt::format("<th scope=\"col\">{}</th>", escape_html(column));
  }
  return cells;
}

std::string group_cells(const HtmlTable& table) {
  std::string cells;
  for (const HtmlHeading& group : table.groups) {
    cells += group.text.empty() ? std::string("<td></td>")
                                : fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>",
                                              group.columns, escape_html(group.text));
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

}  // namespace

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

std::string render(const HtmlTable& table) {
  std::string html = fmt::format(
      "<div class=\"scroll\" role=\"group\" aria-label=\"Table\" "
      "tabindex=\"0\"><table{}>\n<caption>{}</caption>\n<thead>",
      table.numeric ? " class=\"numeric\"" : "", table.caption_html);
  if (!table.groups.empty()) {
    html += "<tr>" + group_cells(table) + "</tr>\n";
  }
  html += "<tr>" + heading_cells(table) + "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    html += "<tr>" + body_cells(row) + "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string html_section(std::string_view title, std::string_view content_html) {
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escape_html(title), content_html);
}

}  // namespace foveola::analysis
