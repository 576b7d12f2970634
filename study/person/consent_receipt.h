// Writes a participant's receipt: the texts they consented to, when, and how to withdraw the data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/record/study_store.h"

namespace foveola::study {

/// Returns plain text with each consent of a session's log and the text that was agreed to; empty
/// if the log has no consent. It has the participant's code and no name. begun_with: the text of
/// the protocol that the study was begun with. Throws Error if a protocol's text is not TOML.
std::optional<std::string> consent_receipt(const std::string& begun_with,
                                           const std::string& participant,
                                           const std::vector<LoggedEvent>& events);

}  // namespace foveola::study
