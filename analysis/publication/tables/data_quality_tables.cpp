#include "analysis/dataset/session_columns.h"
#include "analysis/publication/tables/result_tables.h"

namespace foveola::analysis {

Table data_quality_table(const StudyTables& tables, const DataQualityReport& report) {
  using C = DataQualityCheck;
  const ColumnsOf<C> columns = {
      {"check", "", "Name of the check", &C::name},
      {"found", "", "Value found, with its unit", &C::value_text},
      {"limit", "", "Limit of the value, and its source", &C::limit},
      {"verdict", "", "Result: passed, flagged, or not recorded", &C::verdict},
      kind_of_all<C>(tables)};
  return tabulate("data_quality", "check", columns, report.checks);
}

Table latency_table(const StudyTables& tables, const DataQualityReport& report) {
  using F = study::FrameFigures;
  const ColumnsOf<F> columns = {
      {"participant", "", "Code of the participant", &F::participant},
      {"frames", "", "Number of frames presented in the attempts that count", &F::frames},
      {"late_frames", "", "Number of frames that missed their refresh", &F::late},
      {"untracked_frames", "",
       "Number of frames whose newest gaze was not valid, or older than a blink lasts (600 ms)",
       &F::untracked},
      {"mean_gaze_age_s", "s", "Mean age of the gaze that a frame used", &F::mean_gaze_age_s},
      {"mean_poll_to_display_s", "s", "Mean time from polling to the display",
       &F::mean_to_display_s},
      {"longest_frame_s", "s", "Maximum time from one presented frame to the next",
       &F::longest_frame_s},
      {"marks", "", "Number of marks upon these frames", &F::marks},
      {"mean_frame_to_mark_s", "s", "Mean time from the frame on the display to a mark",
       &F::mean_mark_after_frame_s},
      {"longest_frame_to_mark_s", "s", "Maximum time from the frame on the display to a mark",
       &F::longest_mark_after_frame_s},
      kind_of_all<F>(tables)};
  return tabulate("latency", "session with a frame log", columns, report.frames);
}

Table catch_trials_table(const StudyTables& tables, const DataQualityReport& report) {
  using C = CatchFigures;
  const ColumnsOf<C> columns = {
      {"participant", "", "Code of the participant", &C::participant},
      {"catch_trials", "", "Number of catch trials that were begun: nothing was rendered in them",
       &C::trials},
      {"false_alarms", "", "Number of catch trials with a mark before the time-out",
       &C::false_alarms},
      {"false_alarms_percent", "%", "false_alarms in per cent of catch_trials",
       &C::false_alarms_percent},
      kind_of_all<C>(tables)};
  return tabulate("catch_trials", "participant with catch trials", columns, report.catches);
}

Table outlying_times_table(const StudyTables& tables, const DataQualityReport& report) {
  using O = OutlyingTime;
  const ColumnsOf<O> columns = {
      {"mark", "", mark_meaning, &O::mark},
      {"participant", "", "Code of the participant", &O::participant},
      {"scene", "", "Name of the scene", &O::scene},
      {"method", "", "Id of the method", &O::method},
      {"time_s", "s", "Outlying time, which stays in all results", &O::seconds},
      {"times_expected", "", "time_s over the time expected of its participant, scene and method",
       &O::ratio_to_expected},
      {"studentized_residual", "", "Externally studentized residual of the logarithm of time_s",
       &O::studentized},
      kind_of_all<O>(tables)};
  return tabulate("outlying_times", "outlying time", columns, report.outliers);
}

Table reaction_times_table(const StudyTables& tables, const DataQualityReport& report) {
  using R = ReactionFloor;
  const ColumnsOf<R> columns = {
      {"participant", "", "Code of the participant", &R::participant},
      {"presses", "", "Number of presses after the stimulus", &R::presses},
      {"false_starts", "", "Number of presses before the stimulus", &R::false_starts},
      {"median_s", "s", "Median reaction time", &R::median_s},
      {"marks", "", "Number of the participant's measured times, of all marks", &R::marks},
      {"marks_within_median", "", "Number of measured times no longer than median_s",
       &R::within_floor},
      kind_of_all<R>(tables)};
  return tabulate("reaction_times", "participant who took the reaction test", columns,
                  report.reactions);
}

}  // namespace foveola::analysis
