// What a protocol means, its orders and how long a session takes, as plain aligned text.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "study/design/balance.h"
#include "study/design/duration.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// What a protocol means; sources are its scenes as they were found.
std::string protocol_table(const Protocol& protocol, const std::vector<SceneSource>& sources);

/// One line for each participant and scene, in their order; practice on lines of its own, catch
/// trials in brackets.
std::string plan_table(const std::vector<Plan>& plans);

/// How often each method and scene stands where and follows which, with the largest differences.
std::string balance_table(const Protocol& protocol, const Balance& balance);

/// How long a session takes, part by part, in minutes, with what was assumed.
std::string duration_table(const std::vector<SessionPart>& parts);

}  // namespace foveola::study
