// The option --gaze-filter, for commands that follow a gaze.
#pragma once

#include <string>

#include "renderer/gaze/gaze_filter.h"

namespace foveola {

/// The notation, for help texts.
inline constexpr const char* gaze_filter_notation =
    "none, or with commas between them one-euro[=MIN_CUTOFF_HZ:BETA_PER_DEG:DERIVATIVE_CUTOFF_HZ], "
    "extrapolate=SECONDS and hold[=SECONDS]";

/// The filters in `text`, as "one-euro,extrapolate=0.03,hold": missing values are the defaults, and
/// the order is irrelevant. Throws UsageError that names --gaze-filter.
GazeFilterSettings parse_gaze_filter(const std::string& text);

}  // namespace foveola
