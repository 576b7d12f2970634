// Whether the data are as good as the study needs: what the report raises a flag for.
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
  std::string found;  ///< in words, with units
  std::string limit;  ///< what it is held against, and whose limit that is
  Verdict verdict = Verdict::unknown;
};

/// One participant's reaction test, of presses that were no false starts.
struct ReactionFloor {
  std::string participant;
  std::size_t presses = 0;
  std::size_t false_starts = 0;
  std::optional<double> median_s;
  std::size_t marks = 0;         ///< measured times of the participant, both marks
  std::size_t within_floor = 0;  ///< of them, no longer than the median reaction
};

struct DataQualityReport {
  std::vector<DataQualityCheck> checks;
  std::vector<study::FrameFigures> frames;  ///< of the analysed participants who have any
  std::vector<ReactionFloor> reactions;     ///< of the participants who took the test
};

/// Dropped frames, gaze loss, latency, validation, marks against frames, order balance, and whose
/// data these are; of the participants in `tables`.
DataQualityReport check_data_quality(const StudyTables& tables,
                                     const study::DataQualityRecords& quality);

std::string data_quality_csv(const DataQualityReport& report, const std::string& kind);
std::string latency_csv(const DataQualityReport& report, const std::string& kind);
std::string reactions_csv(const DataQualityReport& report, const std::string& kind);

}  // namespace foveola::analysis
