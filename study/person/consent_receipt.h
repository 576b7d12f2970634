// What a participant takes along: what they consented to, when, and how to take it back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"
#include "study/record/study_store.h"

namespace foveola::study {

/// As plain text; empty if the session with these events has no consent. It has the participant's
/// code and no name.
std::optional<std::string> consent_receipt(const Protocol& protocol, const std::string& participant,
                                           const std::vector<LoggedEvent>& events);

}  // namespace foveola::study
