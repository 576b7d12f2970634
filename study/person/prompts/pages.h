// Which page the participant sees.
#pragma once

#include <optional>

#include "study/person/prompts/prompt_state.h"

namespace foveola::study {

/// Over the picture, or instead of it; empty: the picture alone. now: session clock.
std::optional<ScreenPage> page_of(const PromptState& prompt, const SessionContext& context,
                                  Nanoseconds now);

}  // namespace foveola::study
