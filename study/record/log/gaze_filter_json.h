// The filters of a gaze, for the record.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "renderer/gaze/gaze_filter.h"

namespace foveola::study {

/// Those that are wanted, under the keys of a protocol's [tracker.filter]; empty without any.
nlohmann::ordered_json json_of(const GazeFilterSettings& filter);

}  // namespace foveola::study
