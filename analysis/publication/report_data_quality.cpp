#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"
#include "analysis/tables/printed_table.h"

namespace foveola::analysis {
namespace {

constexpr std::size_t most_faults_listed = 100;

std::string in_words(const study::RecordFault& fault) {
  return fault.participant.empty() ? fault.what
                                   : fmt::format("{}: {}", fault.participant, fault.what);
}

std::string fault_list(const std::vector<study::RecordFault>& faults) {
  std::string items = "<ul>\n";
  for (std::size_t i = 0; i < std::min(most_faults_listed, faults.size()); ++i) {
    items += fmt::format("<li>{}</li>\n", escape_html(in_words(faults[i])));
  }
  if (faults.size() > most_faults_listed) {
    items += fmt::format("<li>and {} more, which <code>foveola study verify</code> lists</li>\n",
                         faults.size() - most_faults_listed);
  }
  return items + "</ul>\n";
}

std::string finding(const study::Verification& record) {
  return record.faults.empty() ? "<p>It is unchanged since it was written.</p>\n"
                               : "<p>It was changed or damaged since it was written, and was "
                                 "analysed all the same, as was asked for with "
                                 "<code>--unverified</code>:</p>\n" +
                                     fault_list(record.faults);
}

std::string gaps(const study::Verification& record) {
  return record.gaps.empty()
             ? "<p>Nothing is missing in it.</p>\n"
             : "<p>What is missing in it, which is no damage:</p>\n" + fault_list(record.gaps);
}

std::string warnings_of(const study::Verification& record) {
  return record.warnings.empty()
             ? ""
             : "<p>What is no damage, and is to be known before its dates or times are "
               "compared:</p>\n" +
                   fault_list(record.warnings);
}

constexpr std::size_t most_listed = 100;

std::string rest_in_words(std::size_t rows, const char* file) {
  return rows > most_listed
             ? fmt::format("<p>And {} more in <code>{}</code>.</p>\n", rows - most_listed, file)
             : "";
}

std::string checks_table(const StudyTables& tables, const DataQualityReport& report) {
  PrintedTable table;
  table.is_numeric = false;
  table.title = "Data-quality checks.";
  table.note = "Of the participants whose data are analysed.";
  table.columns = {"Check", "Verdict", "Found", "Limit"};
  for (const DataQualityCheck& check : report.checks) {
    const std::string verdict(name_of(check.verdict));
    table.rows.push_back({check.name, check.verdict == Verdict::flagged ? "⚑ " + verdict : verdict,
                          check.found, check.limit});
  }
  return html_of(table, data_notice(tables));
}

/// The mean latency of each session's frames, from the eye to the display.
std::string latency_html(const StudyTables& tables, const study::DataQualityRecords& quality,
                         const std::optional<PublishedStudy>& published) {
  constexpr std::size_t most_rows = 100;
  PrintedTable table;
  table.title = "Latency from the eye to the display.";
  table.note = joined("From the frame log: means over each session’s frames.",
                      paper_notes(tables, published).latency);
  table.columns = {
      "Participant", "frames",           "age of the gaze, ms", "polling to display, ms",
      "both, ms",    "longest frame, ms"};
  for (std::size_t i = 0; i < std::min(most_rows, quality.frames.size()); ++i) {
    const study::FrameFigures& row = quality.frames[i];
    table.rows.push_back({row.participant, std::to_string(row.frames),
                          fixed(1e3 * row.mean_gaze_age_s, 1),
                          fixed(1e3 * row.mean_to_display_s, 1),
                          fixed(1e3 * (row.mean_gaze_age_s + row.mean_to_display_s), 1),
                          fixed(1e3 * row.longest_frame_s, 1)});
  }
  return html_of(table, data_notice(tables));
}

std::string reactions_table(const StudyTables& tables, const DataQualityReport& report) {
  constexpr std::size_t most_rows = 100;
  PrintedTable table;
  table.title = "Reaction-time floor.";
  table.note =
      "No mark can be sooner than a press: times near the median reaction time mean “at once”.";
  table.columns = {"Participant", "presses", "false starts",
                   "median, s",   "marks",   "marks within the median"};
  for (std::size_t i = 0; i < std::min(most_rows, report.reactions.size()); ++i) {
    const ReactionFloor& row = report.reactions[i];
    table.rows.push_back({row.participant, std::to_string(row.presses),
                          std::to_string(row.false_starts), fixed(row.median_s, 3),
                          std::to_string(row.marks), std::to_string(row.within_floor)});
  }
  return table.rows.empty()
             ? "<p>No reaction test was recorded: the share of the reaction time in a "
               "short time is unknown.</p>\n"
             : html_of(table, data_notice(tables));
}

/// Where the gaze was, in the mean over each method's trials.
std::string gaze_html(const StudyTables& tables, const DataQualityReport& report) {
  if (report.gaze.empty()) {
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
  for (const MethodGaze& row : report.gaze) {
    table.rows.push_back({method_label(row.method), std::to_string(row.trials),
                          fixed(row.on_object_percent, 1), fixed(row.elsewhere_percent, 1),
                          fixed(row.without_gaze_percent, 1), fixed(row.fixations, 1),
                          fixed(row.gaze_from_object_deg, 1)});
  }
  return html_of(table, data_notice(tables));
}

std::string catches_html(const StudyTables& tables, const DataQualityReport& report) {
  constexpr std::size_t most_rows = 100;
  PrintedTable table;
  table.title = "Catch trials.";
  table.note = "Nothing was rendered in them: a mark before the time-out is a false alarm.";
  table.columns = {"Participant", "catch trials", "false alarms"};
  for (std::size_t i = 0; i < std::min(most_rows, report.catches.size()); ++i) {
    const CatchFigures& row = report.catches[i];
    table.rows.push_back(
        {row.participant, std::to_string(row.trials), std::to_string(row.false_alarms)});
  }
  return html_of(table, data_notice(tables));
}

/// The number of trials that were timed again, and the most attempts.
std::string attempts_in_words(const Dataset& set) {
  std::size_t again = 0;
  int most = 0;
  for (const Trial& trial : set.trials) {
    again += trial.attempts > 1 ? 1 : 0;
    most = std::max(most, trial.attempts);
  }
  return again == 0 ? "No trial was timed again."
                    : fmt::format(
                          "{} of {} were timed again, at most {} times in all; the last "
                          "timing counts.",
                          again, counted(set.trials.size(), "trial"), most);
}

}  // namespace

std::string data_quality_flags(const StudyTables& tables, const DataQualityReport& report) {
  std::string items;
  for (const DataQualityCheck& check : report.checks) {
    // The top of the report says already that data are simulated or a pilot's.
    if (check.verdict == Verdict::flagged && check.found != data_warning(tables)) {
      items += fmt::format("<li>⚑ {}: {} (limit: {})</li>\n", escape_html(check.name),
                           escape_html(check.found), escape_html(check.limit));
    }
  }
  return items.empty()
             ? ""
             : "<div class=\"flags\" role=\"note\"><p>Data-quality limits missed:</p>\n<ul>\n" +
                   items + "</ul></div>\n";
}

std::string data_quality_section(const StudyTables& tables, const DataQualityReport& report,
                                 const study::DataQualityRecords& quality,
                                 const std::optional<PublishedStudy>& published) {
  return html_section("Data quality",
                      checks_table(tables, report) +
                          fmt::format("<p>{}</p>\n", escape_html(attempts_in_words(tables.set))) +
                          latency_html(tables, quality, published) + gaze_html(tables, report) +
                          reactions_table(tables, report) + catches_html(tables, report));
}

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

std::string record_flags(const std::optional<study::Verification>& record) {
  if (!record || record->faults.empty()) {
    return "";
  }
  return fmt::format(
      "<div class=\"flags\" role=\"note\"><p>⚑ The study’s file is not what was written ({}): any "
      "number here may be wrong.</p></div>\n",
      counted(record->faults.size(), "fault"));
}

std::string record_section(const std::optional<study::Verification>& record) {
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
                  counted(record->events, "event"), counted(record->sessions, "session"),
                  counted(record->chunks, "chunk")) +
          finding(*record) + gaps(*record) + warnings_of(*record));
}

}  // namespace foveola::analysis
