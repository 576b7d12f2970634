// Data-quality checks: whether frames, gaze, latency, sessions and orders were as good as the study
// needs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/gaze_by_trial.h"
#include "analysis/dataset/mark_survival.h"
#include "analysis/dataset/study_tables.h"
#include "study/record/data_quality_records.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

enum class Verdict { passed, flagged, unknown };

/// "passed", "flagged", "not recorded".
std::string_view name_of(Verdict verdict);

/// Passed if it is good, else flagged.
Verdict within(bool good);

struct DataQualityCheck {
  std::string name;
  std::string found;  ///< The value found, in words, with its unit.
  std::string limit;  ///< The limit, and its source.
  Verdict verdict = Verdict::unknown;
};

/// Something that a check found of one participant.
struct Finding {
  std::string participant;
  std::string words;  ///< Begins with the participant's code.
};

/// The first few of them, then how many others there are, and of whom: nobody goes unnamed. Empty
/// if there are none.
std::string findings_in_words(const std::vector<Finding>& findings);

/// ": " and findings_in_words; empty if there are none.
std::string colon_and_findings(const std::vector<Finding>& findings);

/// One participant's catch trials, in which nothing is rendered: a mark is a false alarm.
struct CatchFigures {
  std::string participant;
  std::size_t trials = 0;        ///< Catch trials that were begun.
  std::size_t false_alarms = 0;  ///< Those with a mark before the time-out.

  double false_alarms_percent() const {
    return 100.0 * static_cast<double>(false_alarms) / static_cast<double>(trials);
  }
};

/// One participant's reaction test, and how many of the marks are as short as a reaction.
struct ReactionFloor {
  std::string participant;
  std::size_t presses = 0;
  std::size_t false_starts = 0;
  std::optional<double> median_s;  ///< Median reaction time, without false starts.
  std::size_t marks = 0;           ///< The participant's measured times, of all marks.
  std::size_t within_floor = 0;    ///< Those no longer than the median reaction.
};

struct DataQualityReport {
  std::vector<DataQualityCheck> checks;
  std::vector<study::FrameFigures> frames;  ///< One for each analysed participant with frames.
  std::vector<ReactionFloor> reactions;     ///< One for each participant who took the test.
  std::vector<CatchFigures> catches;        ///< One for each participant with catch trials.
  std::vector<OutlyingTime> outliers;       ///< Times that stand out from the others.
  std::vector<MethodGaze> gaze;             ///< One for each method; none if no gaze is known.
};

/// Checks dropped frames, gaze loss, latency, validation, the delay from frames to marks, objects
/// out of view at marks, the gaze elsewhere than on the object, sessions that were cut off, trials
/// timed again, notes, the balance of orders, false alarms, single times that stand out, and
/// whether the data are people's; for the participants in `tables`. Whoever misses a limit of their
/// own is named.
DataQualityReport check_data_quality(const StudyTables& tables,
                                     const study::DataQualityRecords& quality,
                                     const study::StudyRecords& records);

}  // namespace foveola::analysis
