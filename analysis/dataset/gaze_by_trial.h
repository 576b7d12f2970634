// Tabulates gaze relative to the object: columns per trial, means per method.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/tables/table.h"
#include "study/record/read/data_quality_records.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// One pointer per row of records.trials; null if its frames were not recorded.
using GazeOfTrials = std::vector<const study::AttemptGazeRow*>;

/// Returns pointers into `gaze`, valid as long as its rows.
GazeOfTrials gaze_of_trials(const study::StudyRecords& records,
                            std::span<const study::AttemptGazeRow> gaze);

/// Returns the columns of the gaze in one trial: fractions of the time, fixations, and gaze and
/// object at each mark of the measures.
ColumnsOf<study::AttemptGazeFigures> gaze_columns(const std::vector<Measure>& measures);

/// Returns the indices in records.trials of the final timing of each test trial of the analysed
/// participants.
std::vector<std::size_t> analysed_trials(const study::StudyRecords& records, const Dataset& set);

/// Fractions of a trial's time in per cent; unknown ones are empty.
struct GazePercents {
  std::optional<double> on_object;
  std::optional<double> elsewhere;
  std::optional<double> without_gaze;
};
GazePercents percents_of(const std::optional<study::GazeTimes>& times);

/// Means over the trials of one method in which each figure is known.
struct MethodGaze {
  std::string method;
  std::size_t trials = 0;  ///< With recorded frames up to the last mark.
  std::optional<double> on_object_percent;
  std::optional<double> elsewhere_percent;
  std::optional<double> without_gaze_percent;
  std::optional<double> fixations;             ///< Mean number per trial.
  std::optional<double> gaze_from_object_deg;  ///< At all marks.
};

/// Returns one entry per method, of analysed test trials; empty if no trial has gaze.
std::vector<MethodGaze> gaze_by_method(const study::StudyRecords& records, const Dataset& set,
                                       const GazeOfTrials& gaze);

}  // namespace foveola::analysis
