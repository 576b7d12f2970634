// Where gaze and object were in each trial, as columns, and over the trials of a method.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/tables/table.h"
#include "study/record/data_quality_records.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// What is known of the gaze in each row of the records' trials; null if no frames of it were
/// recorded.
using GazeOfTrials = std::vector<const study::AttemptGazeRow*>;

/// Points into `gaze`.
GazeOfTrials gaze_of_trials(const study::StudyRecords& records,
                            std::span<const study::AttemptGazeRow> gaze);

/// The columns of a timing's gaze: shares of the time, fixations, and gaze and object at each mark
/// of the measures.
ColumnsOf<study::AttemptGazeFigures> gaze_columns(const std::vector<Measure>& measures);

/// The indices of the records' test trials of analysed participants, of each trial its last timing.
std::vector<std::size_t> analysed_trials(const study::StudyRecords& records, const Dataset& set);

/// The parts of a trial's time in per cent; each is empty if it is not known.
struct GazePercents {
  std::optional<double> on_object;
  std::optional<double> elsewhere;
  std::optional<double> without_gaze;
};
GazePercents percents_of(const std::optional<study::GazeTimes>& times);

/// The trials of one method: means over those of which each figure is known.
struct MethodGaze {
  std::string method;
  std::size_t trials = 0;  ///< With recorded frames up to the last mark.
  std::optional<double> on_object_percent;
  std::optional<double> elsewhere_percent;
  std::optional<double> without_gaze_percent;
  std::optional<double> fixations;
  std::optional<double> gaze_from_object_deg;  ///< At all marks.
};

/// One for each method, of analysed test trials; empty if there are no such trials at all.
std::vector<MethodGaze> gaze_by_method(const study::StudyRecords& records, const Dataset& set,
                                       const GazeOfTrials& gaze);

}  // namespace foveola::analysis
