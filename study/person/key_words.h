// What the participant's next key is for, in the experimenter's words.
#pragma once

#include <string>

#include "study/person/prompt_state.h"

namespace foveola::study {

/// "Space marks outline".
std::string words_for_next_key(const PromptState& prompt, const SessionContext& context);

}  // namespace foveola::study
