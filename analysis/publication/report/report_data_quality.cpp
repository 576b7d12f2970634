#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/publication/report/report_parts.h"
#include "analysis/publication/report/report_sections.h"
#include "analysis/publication/tables/result_tables.h"
#include "analysis/tables/html.h"
#include "analysis/tables/row_text.h"

namespace foveola::analysis {
namespace {

constexpr std::size_t max_listed = 100;

std::string in_words(const study::RecordFault& fault) {
  return fault.participant.empty() ? fault.what
                                   : fmt::format("{}: {}", fault.participant, fault.what);
}

std::string fault_list(const std::vector<study::RecordFault>& faults) {
  std::string items = "<ul>\n";
  for (std::size_t i = 0; i < std::min(max_listed, faults.size()); ++i) {
    items += fmt::format("<li>{}</li>\n", escape_html(in_words(faults[i])));
  }
  if (faults.size() > max_listed) {
    items += fmt::format("<li>and {} more, which <code>foveola study verify</code> lists</li>\n",
                         faults.size() - max_listed);
  }
  return items + "</ul>\n";
}

std::string finding(const study::Verification& record) {
  return record.faults.empty() ? "<p>It is unchanged since it was written.</p>\n"
                               : "<p>It was changed or damaged since it was written, and is "
                                 "analysed nevertheless, because of "
                                 "<code>--unverified</code>:</p>\n" +
                                     fault_list(record.faults);
}

std::string gaps(const study::Verification& record) {
  return record.gaps.empty()
             ? "<p>Nothing is missing in it.</p>\n"
             : "<p>Missing parts, which are not a sign of damage:</p>\n" + fault_list(record.gaps);
}

std::string warnings_of(const study::Verification& record) {
  return record.warnings.empty() ? ""
                                 : "<p>Findings that are not a sign of damage, to be considered "
                                   "before dates or times are "
                                   "compared:</p>\n" +
                                       fault_list(record.warnings);
}

std::string rest_in_words(std::size_t rows, const char* file) {
  return rows > max_listed
             ? fmt::format("<p>And {} more in <code>{}</code>.</p>\n", rows - max_listed, file)
             : "";
}

PrintedTable shortened(PrintedTable table) {
  table.rows.resize(std::min(max_listed, table.rows.size()));
  return table;
}

std::string checks_table(const ReportContent& content) {
  return table_html(content.tables,
                    print_rows({.title = "Data-quality checks.",
                                .note = "Of the participants whose data are analysed.",
                                .is_numeric = false},
                               table_named(content.results, "data_quality"), "",
                               {{"Check", "{check}"},
                                {"Verdict", "{verdict=flagged}⚑ {verdict}", "{verdict}"},
                                {"Found", "{found}"},
                                {"Limit", "{limit}"}}));
}

std::string latency_html(const ReportContent& content) {
  PrintedTable table;
  table.title = "Latency from the eye to the display.";
  table.note = join_sentences("From the frame log: means over each session’s frames.",
                              paper_notes(content.tables, content.published).latency);
  table.columns = {
      "Participant", "frames",           "age of the gaze, ms", "polling to display, ms",
      "both, ms",    "longest frame, ms"};
  for (const study::FrameFigures& row : content.quality.frames) {
    table.rows.push_back({row.participant, std::to_string(row.frames),
                          fixed(1e3 * row.mean_gaze_age_s, 1),
                          fixed(1e3 * row.mean_to_display_s, 1),
                          fixed(1e3 * (row.mean_gaze_age_s + row.mean_to_display_s), 1),
                          fixed(1e3 * row.longest_frame_s, 1)});
  }
  return table_html(content.tables, shortened(std::move(table)));
}

std::string reactions_table(const ReportContent& content) {
  const Table& reactions = table_named(content.results, "reaction_times");
  if (reactions.rows.empty()) {
    return "<p>No reaction test was recorded: the share of the reaction time in a short time is "
           "unknown.</p>\n";
  }
  return table_html(
      content.tables,
      shortened(print_rows({.title = "Reaction-time floor.",
                            .note = "No mark can be sooner than a press: times near the median "
                                    "reaction time mean “at once”."},
                           reactions, "",
                           {{"Participant", "{participant}"},
                            {"presses", "{presses}"},
                            {"false starts", "{false_starts}"},
                            {"median, s", "{median_s:.3}"},
                            {"marks", "{marks}"},
                            {"marks within the median", "{marks_within_median}"}})));
}

std::string gaze_html(const ReportContent& content) {
  if (content.checks.gaze.empty()) {
    return "<p>No frames were recorded: where gaze and object were is unknown.</p>\n";
  }
  PrintedTable table;
  table.title = "Gaze by trial.";
  table.note = fmt::format(
      "Means over the trials of each method, of the time from the first frame to the last mark. On "
      "the object: within {:g}° of its angular radius. gaze_by_trial.csv has every trial.",
      study::gaze_margin_deg);
  table.columns = {"Method",           "trials",    "on the object, %",          "elsewhere, %",
                   "no valid gaze, %", "fixations", "gaze to object at marks, °"};
  for (const MethodGaze& row : content.checks.gaze) {
    table.rows.push_back({method_label(row.method), std::to_string(row.trials),
                          fixed(row.on_object_percent, 1), fixed(row.elsewhere_percent, 1),
                          fixed(row.without_gaze_percent, 1), fixed(row.fixations, 1),
                          fixed(row.gaze_from_object_deg, 1)});
  }
  return table_html(content.tables, table);
}

std::string catches_html(const ReportContent& content) {
  return table_html(
      content.tables,
      shortened(print_rows(
          {.title = "Catch trials.",
           .note = "Nothing was rendered in them: a mark before the time-out is a false alarm."},
          table_named(content.results, "catch_trials"), "",
          {{"Participant", "{participant}"},
           {"catch trials", "{catch_trials}"},
           {"false alarms", "{false_alarms}"}})));
}

/// The number of retimed trials, and the maximum number of attempts.
std::string attempts_in_words(const Dataset& set) {
  std::size_t again = 0;
  int most = 0;
  for (const Trial& trial : set.trials) {
    again += trial.attempts > 1 ? 1 : 0;
    most = std::max(most, trial.attempts);
  }
  return again == 0 ? "No trial was retimed."
                    : fmt::format(
                          "{} of {} were retimed, up to {} timings in all; the last "
                          "timing counts.",
                          again, count_with_noun(set.trials.size(), "trial"), most);
}

}  // namespace

std::string data_quality_flags(const ReportContent& content) {
  std::string items;
  for (const DataQualityCheck& check : content.checks.checks) {
    // The report's top already says that data are simulated or a pilot's.
    if (check.verdict == Verdict::flagged && check.value_text != data_warning(content.tables)) {
      items += fmt::format("<li>⚑ {}: {} (limit: {})</li>\n", escape_html(check.name),
                           escape_html(check.value_text), escape_html(check.limit));
    }
  }
  return items.empty()
             ? ""
             : "<div class=\"flags\" role=\"note\"><p>Data-quality limits missed:</p>\n<ul>\n" +
                   items + "</ul></div>\n";
}

std::string data_quality_section(const ReportContent& content) {
  return html_section(
      "Data quality",
      checks_table(content) +
          fmt::format("<p>{}</p>\n", escape_html(attempts_in_words(content.tables.set))) +
          latency_html(content) + gaze_html(content) + reactions_table(content) +
          catches_html(content));
}

std::string amended_section(const ReportContent& content) {
  const StudyTables& tables = content.tables;
  if (tables.amended.empty()) {
    return html_section("Amended sessions",
                        "<p>None: every session followed the protocol of the study.</p>\n");
  }
  PrintedTable table;
  table.is_numeric = false;
  table.title = "Sessions that followed an amended protocol.";
  table.note =
      "Words or time-outs were changed after the study had begun; the design was "
      "not. They are analysed with the others where a session is.";
  table.columns = {"Participant", "Changed keys", "SHA-256 of the text", "Analysed"};
  for (const AmendedSession& row : tables.amended) {
    table.rows.push_back(
        {row.participant,
         row.changed_keys.empty() ? "none: comments or spaces only" : comma_list(row.changed_keys),
         row.protocol_sha256, row.is_analysed ? "yes" : "no"});
  }
  return html_section("Amended sessions",
                      table_html(tables, shortened(std::move(table))) +
                          rest_in_words(tables.amended.size(), "amended_sessions.csv"));
}

std::string exclusions_section(const ReportContent& content) {
  const std::vector<Exclusion>& exclusions = content.tables.set.exclusions;
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
  const PrintedTable table = print_rows(
      {.title = "Excluded sessions and values.",
       .note = "A dash means all. The trials of sessions that are not analysed are in "
               "trials_long.csv, with their status; those of withdrawn sessions only if the "
               "analysis was run with --withdrawn.",
       .is_numeric = false},
      with_method_labels(table_named(content.results, "exclusions")), "",
      {{"Participant", "{participant}"},
       {"Scene", "{scene}"},
       {"Method", "{method}"},
       {"Measure", "{measure}"},
       {"Reason", "{reason}"}});
  return html_section("Exclusions", html + table_html(content.tables, shortened(table)) +
                                        rest_in_words(exclusions.size(), "exclusions.csv"));
}

std::string record_flags(const ReportContent& content) {
  const std::optional<study::Verification>& record = content.record;
  if (!record || record->faults.empty()) {
    return "";
  }
  return fmt::format(
      "<div class=\"flags\" role=\"note\"><p>⚑ The study’s file failed its verification ({}): any "
      "number here may be wrong.</p></div>\n",
      count_with_noun(record->faults.size(), "fault"));
}

std::string record_section(const ReportContent& content) {
  const std::optional<study::Verification>& record = content.record;
  if (!record) {
    return html_section("The record",
                        "<p>These data do not come from a study’s file: there is no record to "
                        "verify.</p>\n");
  }
  return html_section(
      "The record",
      fmt::format("<p>The study’s file was verified before it was read, as <code>foveola study "
                  "verify</code> does: by SQLite’s own checks, the hash chains over {} of {}, the "
                  "checksums of {} of frames and gaze, and whether every table follows from the "
                  "events.</p>\n",
                  count_with_noun(record->events, "event"),
                  count_with_noun(record->sessions, "session"),
                  count_with_noun(record->chunks, "chunk")) +
          finding(*record) + gaps(*record) + warnings_of(*record));
}

}  // namespace foveola::analysis
