#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"
#include "analysis/tables/printed_table.h"

namespace foveola::analysis {

namespace {

constexpr std::size_t most_listed = 100;

std::string rest_in_words(std::size_t rows, const char* file) {
  return rows > most_listed
             ? fmt::format("<p>And {} more in <code>{}</code>.</p>\n", rows - most_listed, file)
             : "";
}

}  // namespace

std::string amended_section(const StudyTables& tables) {
  if (tables.amended.empty()) {
    return html_section("Amended sessions",
                        "<p>None: every session followed the protocol of the study.</p>\n");
  }
  PrintedTable table;
  table.is_numeric = false;
  table.title = "Sessions by an amended protocol.";
  table.note =
      "Words or time-outs were changed after the study had begun; the design was "
      "not. They are analysed with the others where a session is.";
  table.columns = {"Participant", "Changed keys", "SHA-256 of the text", "Analysed"};
  for (std::size_t i = 0; i < std::min(most_listed, tables.amended.size()); ++i) {
    const AmendedSession& row = tables.amended[i];
    table.rows.push_back(
        {row.participant,
         row.changed_keys.empty() ? "none: comments or spaces only" : listed(row.changed_keys),
         row.protocol_sha256, row.is_analysed ? "yes" : "no"});
  }
  return html_section("Amended sessions",
                      html_of(table, data_notice(tables)) +
                          rest_in_words(tables.amended.size(), "amended_sessions.csv"));
}

std::string exclusions_section(const StudyTables& tables) {
  const std::vector<Exclusion>& exclusions = tables.set.exclusions;
  if (exclusions.empty()) {
    return html_section("Exclusions",
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
  PrintedTable table;
  table.is_numeric = false;
  table.title = "Excluded sessions and values.";
  table.note =
      "A dash means all. The trials of sessions that are not analysed are in trials_long.csv, with "
      "their status; those of withdrawn sessions only if the analysis was run with --withdrawn.";
  table.columns = {"Participant", "Scene", "Method", "Measure", "Reason"};
  const auto or_all = [](const std::string& text) { return text.empty() ? "–" : text; };
  for (std::size_t i = 0; i < std::min(most_listed, exclusions.size()); ++i) {
    const Exclusion& row = exclusions[i];
    table.rows.push_back({row.participant, or_all(row.scene),
                          or_all(row.method.empty() ? "" : method_label(row.method)),
                          or_all(row.measure), row.reason});
  }
  return html_section("Exclusions", html + html_of(table, data_notice(tables)) +
                                        rest_in_words(exclusions.size(), "exclusions.csv"));
}

}  // namespace foveola::analysis
