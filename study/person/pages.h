// Selects the page that the participant sees.
#pragma once

#include <optional>

#include "study/person/prompt_state.h"

namespace foveola::study {

/// Returns the page over the picture, or in place of it; empty: the picture alone. now: session
/// clock.
std::optional<ScreenPage> page_of(const PromptState& prompt, const SessionContext& context,
                                  Nanoseconds now);

}  // namespace foveola::study
