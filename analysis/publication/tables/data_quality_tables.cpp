#include "analysis/publication/tables/result_tables.h"

namespace foveola::analysis {

Table data_quality_table(const StudyTables& tables, const DataQualityReport& report) {
  using C = DataQualityCheck;
  const ColumnsOf<C> columns = {{"check", "", "What was checked", &C::name},
                                {"found", "", "What was found, with its unit", &C::found},
                                {"limit", "", "The limit, and its source", &C::limit},
                                {"verdict", "", "passed, flagged, or not recorded", &C::verdict},
                                kind_of_all<C>(tables)};
  return tabulate("data_quality", "check", columns, report.checks);
}

Table latency_table(const StudyTables& tables, const DataQualityReport& report) {
  using F = study::FrameFigures;
  const ColumnsOf<F> columns = {
      {"participant", "", "Code of the participant", &F::participant},
      {"frames", "", "Frames presented in the attempts that count", &F::frames},
      {"late_frames", "", "Frames that missed their refresh", &F::late},
      {"untracked_frames", "",
       "Frames whose newest gaze was not valid, or older than a blink lasts (600 ms)",
       &F::untracked},
      {"mean_gaze_age_s", "s", "Mean age of the gaze that a frame used", &F::mean_gaze_age_s},
      {"mean_poll_to_display_s", "s", "Mean time from polling to the display",
       &F::mean_to_display_s},
      {"longest_frame_s", "s", "Longest time from one presented frame to the next",
       &F::longest_frame_s},
      {"marks", "", "Marks upon these frames", &F::marks},
      {"mean_frame_to_mark_s", "s", "Mean time from the frame on the display to a mark",
       &F::mean_mark_after_frame_s},
      {"longest_frame_to_mark_s", "s", "The longest of these", &F::longest_mark_after_frame_s},
      kind_of_all<F>(tables)};
  return tabulate("latency", "session with a frame log", columns, report.frames);
}

Table catch_trials_table(const StudyTables& tables, const DataQualityReport& report) {
  using C = CatchFigures;
  const ColumnsOf<C> columns = {
      {"participant", "", "Code of the participant", &C::participant},
      {"catch_trials", "", "Catch trials that were begun: nothing was rendered in them",
       &C::trials},
      {"false_alarms", "", "Those in which the participant marked before the time-out",
       &C::false_alarms},
      {"false_alarms_percent", "%", "The same in per cent", &C::false_alarms_percent},
      kind_of_all<C>(tables)};
  return tabulate("catch_trials", "participant with catch trials", columns, report.catches);
}

Table outlying_times_table(const StudyTables& tables, const DataQualityReport& report) {
  using O = OutlyingTime;
  const ColumnsOf<O> columns = {
      {"mark", "", "Id of the mark", &O::mark},
      {"participant", "", "Code of the participant", &O::participant},
      {"scene", "", "Name of the scene", &O::scene},
      {"method", "", "Id of the method", &O::method},
      {"time_s", "s", "The time, which stays in all results", &O::seconds},
      {"times_expected", "",
       "How many times the time that its participant, scene and method let one expect",
       &O::times_expected},
      {"studentized_residual", "", "Of its logarithm, when it was taken out", &O::studentized},
      kind_of_all<O>(tables)};
  return tabulate("outlying_times", "single time that stands out", columns, report.outliers);
}

Table reaction_times_table(const StudyTables& tables, const DataQualityReport& report) {
  using R = ReactionFloor;
  const ColumnsOf<R> columns = {
      {"participant", "", "Code of the participant", &R::participant},
      {"presses", "", "Presses at what appeared, without false starts", &R::presses},
      {"false_starts", "", "Presses before anything appeared", &R::false_starts},
      {"median_s", "s", "Median reaction time", &R::median_s},
      {"marks", "", "The participant's measured times, of all marks", &R::marks},
      {"marks_within_median", "", "Those no longer than the median reaction time",
       &R::within_floor},
      kind_of_all<R>(tables)};
  return tabulate("reaction_times", "participant who took the reaction test", columns,
                  report.reactions);
}

}  // namespace foveola::analysis
