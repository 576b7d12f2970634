#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "analysis/publication/html.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/publication/wording.h"

namespace foveola::analysis {

std::string exclusions_section(const StudyTables& tables) {
  constexpr std::size_t most_rows = 100;
  const std::vector<Exclusion>& exclusions = tables.set.exclusions;
  if (exclusions.empty()) {
    return html_section("What was left out",
                        "<p>Nothing: every session was completed and every value is there.</p>\n");
  }
  std::map<std::string, std::size_t> counts;
  for (const Exclusion& exclusion : exclusions) {
    ++counts[exclusion.reason];
  }
  std::string html = "<ul>\n";
  for (const auto& [reason, count] : counts) {
    html += fmt::format("<li>{} × {}</li>\n", count, escape_html(reason));
  }
  html += "</ul>\n";
  HtmlTable table;
  table.numeric = false;
  table.caption_html = caption_start(tables, "Left out, one by one.") + "A dash means all.";
  table.columns = {"Participant", "Scene", "Method", "Measure", "Reason"};
  const auto or_all = [](const std::string& text) { return text.empty() ? "–" : text; };
  for (std::size_t i = 0; i < std::min(most_rows, exclusions.size()); ++i) {
    const Exclusion& row = exclusions[i];
    table.rows.push_back({row.participant, or_all(row.scene),
                          or_all(row.method.empty() ? "" : method_label(row.method)),
                          or_all(row.measure), row.reason});
  }
  html += render(table);
  if (exclusions.size() > most_rows) {
    html += fmt::format("<p>And {} more in <code>exclusions.csv</code>.</p>\n",
                        exclusions.size() - most_rows);
  }
  return html_section("What was left out", html);
}

}  // namespace foveola::analysis
