// Describes a protocol, its orders and a session's duration as aligned plain text.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "study/design/balance.h"
#include "study/design/duration.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Describes a protocol; sources are its scenes as they were found.
std::string protocol_table(const Protocol& protocol, const std::vector<SceneSource>& sources);

/// Returns a line per participant and scene, in their order; practice on lines of its own, catch
/// trials in brackets.
std::string plan_table(const std::vector<Plan>& plans);

/// Returns the counts of positions and successions of methods and scenes, with the maximum
/// differences.
std::string balance_table(const Protocol& protocol, const Balance& balance);

/// Returns the duration of a session's parts in minutes, with the assumptions.
std::string duration_table(const std::vector<SessionPart>& parts);

}  // namespace foveola::study
