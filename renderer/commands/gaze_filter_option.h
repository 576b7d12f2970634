// --gaze-filter, for the commands that follow a gaze.
#pragma once

#include <string>

#include "renderer/gaze/gaze_filter.h"

namespace foveola {

/// The notation, for help texts.
inline constexpr const char* gaze_filter_notation =
    "none, or with commas between them one-euro[=MIN_CUTOFF_HZ:BETA_PER_DEG:DERIVATIVE_CUTOFF_HZ], "
    "extrapolate=SECONDS and hold[=SECONDS]";

/// The filters that `text` names, as "one-euro,extrapolate=0.03,hold": what has no value has its
/// defaults, and the order makes no difference. Throws UsageError, naming --gaze-filter.
GazeFilterSettings parse_gaze_filter(const std::string& text);

}  // namespace foveola
