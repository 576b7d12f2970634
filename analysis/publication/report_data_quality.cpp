#include <algorithm>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"
#include "analysis/tables/printed_table.h"

namespace foveola::analysis {
namespace {

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

}  // namespace foveola::analysis
