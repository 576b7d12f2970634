// Checks the quality of the data: frames, gaze, latency, sessions and orders.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/gaze_by_trial.h"
#include "analysis/dataset/mark_survival.h"
#include "analysis/dataset/study_tables.h"
#include "study/record/read/data_quality_records.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

enum class Verdict { passed, flagged, unknown };

/// Returns "passed", "flagged" or "not recorded".
std::string_view name_of(Verdict verdict);

/// Returns passed if true, else flagged.
Verdict verdict_of(bool is_within_limit);

struct DataQualityCheck {
  std::string name;
  std::string value_text;  ///< The value found, in words, with its unit.
  std::string limit;       ///< The limit, and its source.
  Verdict verdict = Verdict::unknown;
};

/// One finding of a check, about one participant.
struct Finding {
  std::string participant;
  std::string text;  ///< A clause that begins with the participant's code.
};

/// Lists the first few findings, then the number of the others and their participants' codes. Empty
/// without findings.
std::string findings_in_words(const std::vector<Finding>& findings);

/// Returns ": " and findings_in_words; empty without findings.
std::string findings_suffix(const std::vector<Finding>& findings);

/// One participant's catch trials, in which nothing is rendered: a mark is a false alarm.
struct CatchFigures {
  std::string participant;
  std::size_t trials = 0;        ///< Catch trials that were begun.
  std::size_t false_alarms = 0;  ///< Catch trials with a mark before the time-out.

  /// NaN without trials.
  double false_alarms_percent() const {
    return 100.0 * static_cast<double>(false_alarms) / static_cast<double>(trials);
  }
};

/// One participant's reaction test, and the number of marks as fast as a reaction.
struct ReactionFloor {
  std::string participant;
  std::size_t presses = 0;
  std::size_t false_starts = 0;
  std::optional<double> median_s;  ///< Median reaction time, without false starts.
  std::size_t marks = 0;           ///< The participant's measured times, of all marks.
  std::size_t within_floor = 0;    ///< Marks no later than the median reaction time.
};

struct DataQualityReport {
  std::vector<DataQualityCheck> checks;
  std::vector<study::FrameFigures> frames;  ///< One per analysed participant with frames.
  std::vector<ReactionFloor> reactions;     ///< One per participant who took the test.
  std::vector<CatchFigures> catches;        ///< One per participant with catch trials.
  std::vector<OutlyingTime> outliers;       ///< Outlying times.
  std::vector<MethodGaze> gaze;             ///< One per method; empty if no gaze is known.
};

/// Checks the participants of `tables`: dropped frames, gaze loss, latency, validation, the delay
/// from a frame's display to its mark, objects out of view at marks, gaze off the object. Of
/// sessions and trials it checks interruptions, retimed trials, notes, the balance of orders, false
/// alarms, outlying times, and whether the data are people's. The report names each participant
/// whose own value exceeds a per-participant limit.
DataQualityReport check_data_quality(const StudyTables& tables,
                                     const study::DataQualityRecords& quality,
                                     const study::StudyRecords& records);

}  // namespace foveola::analysis
