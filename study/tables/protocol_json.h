// Describes a protocol and its plans in JSON.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "study/design/balance.h"
#include "study/design/duration.h"
#include "study/design/plan.h"

namespace foveola::study {

nlohmann::json json_of(const Protocol& protocol);
nlohmann::json json_of(const Protocol& protocol, const Balance& balance);
nlohmann::json json_of(const std::vector<SessionPart>& parts);

/// Returns the plan of one participant.
nlohmann::json json_of(const Plan& plan);

}  // namespace foveola::study
