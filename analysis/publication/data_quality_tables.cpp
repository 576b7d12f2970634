#include "analysis/publication/data_quality_checks.h"
#include "analysis/publication/result_tables.h"

namespace foveola::analysis {

using enum ColumnType;

Table data_quality_table(const StudyTables& tables, const DataQualityReport& report) {
  using C = DataQualityCheck;
  const ColumnsOf<C> columns = {
      {{"check", text, "", "What was checked"}, [](const C& row) { return field(row.name); }},
      {{"found", text, "", "What was found, with its unit"},
       [](const C& row) { return field(row.found); }},
      {{"limit", text, "", "The limit, and its source"},
       [](const C& row) { return field(row.limit); }},
      {{"verdict", text, "", "passed, flagged, or not recorded"},
       [](const C& row) { return field(std::string(name_of(row.verdict))); }},
      kind_of_all<C>(tables)};
  return tabulate("data_quality", "check", columns, report.checks);
}

Table latency_table(const StudyTables& tables, const DataQualityReport& report) {
  using F = study::FrameFigures;
  const auto count = [](std::uint64_t number) { return field(static_cast<std::size_t>(number)); };
  const ColumnsOf<F> columns = {
      {{"participant", text, "", "Code of the participant"},
       [](const F& row) { return field(row.participant); }},
      {{"frames", whole, "", "Frames presented in the attempts that count"},
       [=](const F& row) { return count(row.frames); }},
      {{"late_frames", whole, "", "Frames that missed their refresh"},
       [=](const F& row) { return count(row.late); }},
      {{"untracked_frames", whole, "",
        "Frames whose newest gaze was not valid, or older than a blink lasts (600 ms)"},
       [=](const F& row) { return count(row.untracked); }},
      {{"mean_gaze_age_s", number, "s", "Mean age of the gaze that a frame used"},
       [](const F& row) { return field(row.mean_gaze_age_s); }},
      {{"mean_poll_to_display_s", number, "s", "Mean time from polling to the display"},
       [](const F& row) { return field(row.mean_to_display_s); }},
      {{"longest_frame_s", number, "s", "Longest time from one presented frame to the next"},
       [](const F& row) { return field(row.longest_frame_s); }},
      {{"marks", whole, "", "Marks upon these frames"},
       [=](const F& row) { return count(row.marks); }},
      {{"mean_frame_to_mark_s", number, "s", "Mean time from the frame on the display to a mark"},
       [](const F& row) { return field(row.mean_mark_after_frame_s); }},
      {{"longest_frame_to_mark_s", number, "s", "The longest of these"},
       [](const F& row) { return field(row.longest_mark_after_frame_s); }},
      kind_of_all<F>(tables)};
  return tabulate("latency", "session with a frame log", columns, report.frames);
}

Table catch_trials_table(const StudyTables& tables, const DataQualityReport& report) {
  using C = CatchFigures;
  const ColumnsOf<C> columns = {
      {{"participant", text, "", "Code of the participant"},
       [](const C& row) { return field(row.participant); }},
      {{"catch_trials", whole, "", "Catch trials that were begun: nothing was rendered in them"},
       [](const C& row) { return field(row.trials); }},
      {{"false_alarms", whole, "", "Those in which the participant marked before the time-out"},
       [](const C& row) { return field(row.false_alarms); }},
      {{"false_alarms_percent", number, "%", "The same in per cent"},
       [](const C& row) { return field(row.false_alarms_percent()); }},
      kind_of_all<C>(tables)};
  return tabulate("catch_trials", "participant with catch trials", columns, report.catches);
}

Table outlying_times_table(const StudyTables& tables, const DataQualityReport& report) {
  using O = OutlyingTime;
  const ColumnsOf<O> columns = {
      {{"mark", text, "", "Id of the mark"}, [](const O& row) { return field(row.mark); }},
      {{"participant", text, "", "Code of the participant"},
       [](const O& row) { return field(row.participant); }},
      {{"scene", text, "", "Name of the scene"}, [](const O& row) { return field(row.scene); }},
      {{"method", text, "", "Id of the method"}, [](const O& row) { return field(row.method); }},
      {{"time_s", number, "s", "The time, which stays in all results"},
       [](const O& row) { return field(row.seconds); }},
      {{"times_expected", number, "",
        "How many times the time that its participant, scene and method let one expect"},
       [](const O& row) { return field(row.times_expected); }},
      {{"studentized_residual", number, "", "Of its logarithm, when it was taken out"},
       [](const O& row) { return field(row.studentized); }},
      kind_of_all<O>(tables)};
  return tabulate("outlying_times", "single time that stands out", columns, report.outliers);
}

Table reaction_times_table(const StudyTables& tables, const DataQualityReport& report) {
  using R = ReactionFloor;
  const ColumnsOf<R> columns = {
      {{"participant", text, "", "Code of the participant"},
       [](const R& row) { return field(row.participant); }},
      {{"presses", whole, "", "Presses at what appeared, without false starts"},
       [](const R& row) { return field(row.presses); }},
      {{"false_starts", whole, "", "Presses before anything appeared"},
       [](const R& row) { return field(row.false_starts); }},
      {{"median_s", number, "s", "Median reaction time"},
       [](const R& row) { return field(row.median_s); }},
      {{"marks", whole, "", "The participant's measured times, of all marks"},
       [](const R& row) { return field(row.marks); }},
      {{"marks_within_median", whole, "", "Those no longer than the median reaction time"},
       [](const R& row) { return field(row.within_floor); }},
      kind_of_all<R>(tables)};
  return tabulate("reaction_times", "participant who took the reaction test", columns,
                  report.reactions);
}

}  // namespace foveola::analysis
