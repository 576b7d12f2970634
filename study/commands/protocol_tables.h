// What a protocol and its plans mean, as plain aligned text.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// What a protocol means; sources are its scenes as they were found.
std::string protocol_table(const Protocol& protocol, const std::vector<SceneSource>& sources);

/// One line for each participant and scene, in their order.
std::string plan_table(const std::vector<Plan>& plans);

}  // namespace foveola::study
