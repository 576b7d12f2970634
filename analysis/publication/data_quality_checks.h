// Data-quality checks: whether frames, gaze, latency and orders were as good as the study needs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/publication/study_tables.h"
#include "study/record/data_quality_records.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

enum class Verdict { passed, flagged, unknown };

/// "passed", "flagged", "not recorded".
std::string_view name_of(Verdict verdict);

struct DataQualityCheck {
  std::string name;
  std::string found;  ///< The value found, in words, with its unit.
  std::string limit;  ///< The limit, and its source.
  Verdict verdict = Verdict::unknown;
};

/// One participant's reaction test, and how many of the marks are as short as a reaction.
struct ReactionFloor {
  std::string participant;
  std::size_t presses = 0;
  std::size_t false_starts = 0;
  std::optional<double> median_s;  ///< Median reaction time, without false starts.
  std::size_t marks = 0;           ///< The participant's measured times, of both marks.
  std::size_t within_floor = 0;    ///< Those no longer than the median reaction.
};

struct DataQualityReport {
  std::vector<DataQualityCheck> checks;
  std::vector<study::FrameFigures> frames;  ///< One for each analysed participant with frames.
  std::vector<ReactionFloor> reactions;     ///< One for each participant who took the test.
};

/// Checks dropped frames, gaze loss, latency, validation, the delay from frames to marks, the
/// balance of orders, and whether the data are people's; for the participants in `tables`.
DataQualityReport check_data_quality(const StudyTables& tables,
                                     const study::DataQualityRecords& quality);

std::string data_quality_csv(const DataQualityReport& report, const std::string& kind);
std::string latency_csv(const DataQualityReport& report, const std::string& kind);
std::string reactions_csv(const DataQualityReport& report, const std::string& kind);

}  // namespace foveola::analysis
