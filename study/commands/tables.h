// What the study's commands print, as plain aligned text.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/scene_source.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"
#include "study/record/study_records.h"

namespace foveola::study {

/// What a protocol means; sources are its scenes as they were found.
std::string protocol_table(const Protocol& protocol, const std::vector<SceneSource>& sources);

/// One line for each participant and scene, in their order.
std::string plan_table(const std::vector<Plan>& plans);

/// How far a study has come.
struct StudyStatus {
  /// Sessions by kind and state.
  std::map<std::pair<std::string, std::string>, int> sessions;
  int trials_done = 0;  ///< with a rating
};
StudyStatus status_of(const StudyRecords& records);

std::string status_table(const StudyRecords& records, const StudyStatus& status);

}  // namespace foveola::study
