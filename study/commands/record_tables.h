// How far a study has come, as plain aligned text.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "study/record/study_records.h"

namespace foveola::study {

/// How far a study has come.
struct StudyStatus {
  /// Sessions by kind and state.
  std::map<std::pair<std::string, std::string>, int> sessions;
  int trials_done = 0;  ///< with a rating
};
StudyStatus status_of(const StudyRecords& records);

std::string status_table(const StudyRecords& records, const StudyStatus& status);

}  // namespace foveola::study
