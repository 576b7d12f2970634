// Selects the participant's page and describes the purpose of its keys.
#pragma once

#include <optional>
#include <string>

#include "study/person/prompts/prompt_state.h"

namespace foveola::study {

/// Returns the page over the picture, or in place of it; empty: the picture alone. now: session
/// clock.
std::optional<ScreenPage> page_of(const PromptState& prompt, const SessionContext& context,
                                  Nanoseconds now);

/// Returns the keys that the participant's page names, in the protocol's words; "[Space] outline"
/// where the picture is marked. now: session clock.
std::string words_for_next_key(const PromptState& prompt, const SessionContext& context,
                               Nanoseconds now);

}  // namespace foveola::study
