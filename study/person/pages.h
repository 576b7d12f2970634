// Which page the participant sees.
#pragma once

#include <optional>

#include "study/person/asked.h"

namespace foveola::study {

/// Over the picture, or instead of it; empty: the picture alone. now: session clock.
std::optional<ScreenPage> page_of(const Asked& asked, const Standing& standing, Nanoseconds now);

}  // namespace foveola::study
