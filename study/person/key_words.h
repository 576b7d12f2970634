// Describes the participant's next key for the experimenter.
#pragma once

#include <string>

#include "study/person/prompt_state.h"

namespace foveola::study {

/// Returns the keys that the participant's page names, in the protocol's words; "[Space] outline"
/// where the picture is marked. now: session clock.
std::string words_for_next_key(const PromptState& prompt, const SessionContext& context,
                               Nanoseconds now);

}  // namespace foveola::study
