// Where gaze and object were in each trial, as columns and rows, and over the trials of a method.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/tables/table.h"
#include "study/record/data_quality_records.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// Finds what is known of the gaze in a timing of a trial.
class GazeOfTrials {
 public:
  /// Both must outlive it.
  GazeOfTrials(const study::StudyRecords& records, std::span<const study::AttemptGazeRow> gaze);

  /// Of the row's index in the records' trials; null if no frames of it were recorded.
  const study::AttemptGazeRow* of(std::size_t trial) const;

 private:
  using Key = std::tuple<std::string_view, std::size_t, int>;  ///< Participant, trial, attempt.

  const study::StudyRecords& records_;
  std::map<Key, const study::AttemptGazeRow*> rows_;
};

/// The columns of a timing's gaze: shares of the time, fixations, and gaze and object at each mark
/// of the measures.
std::vector<Column> gaze_columns(const std::vector<Measure>& measures);

/// Appends their fields to `row`; empty ones where `gaze` is null or lacks something.
void append_gaze(const study::AttemptGazeRow* gaze, const std::vector<Measure>& measures, Row& row);

/// The indices of the records' test trials of analysed participants, of each trial its last timing.
std::vector<std::size_t> analysed_trials(const study::StudyRecords& records, const Dataset& set);

/// The columns and rows of gaze_by_trial: a row for each analysed test trial.
class GazeByTrialColumns {
 public:
  /// All must outlive it.
  GazeByTrialColumns(const study::StudyRecords& records, const Dataset& set,
                     std::span<const study::AttemptGazeRow> gaze);

  const std::vector<Column>& columns() const { return columns_; }
  /// Of the row's index in the records' trials.
  Row row(std::size_t trial) const;

 private:
  const study::StudyRecords& records_;
  const Dataset& set_;
  GazeOfTrials gaze_;
  std::vector<Column> columns_;
};

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
