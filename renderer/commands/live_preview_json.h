// Parts of a live preview's report as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "renderer/window/live_preview.h"

namespace foveola {

/// Frames that were late, by their number from the first, and by how many refreshes.
nlohmann::ordered_json late_frames(const LivePreviewReport& report);

/// What each check of the tracker found, and what is corrected since.
nlohmann::ordered_json gaze_checks(const LivePreviewReport& report);

/// Changes of the scene that were shown or refused, in their order.
nlohmann::ordered_json shown_changes(const LivePreviewReport& report);

/// Null unless drawing was found too slow for the window.
nlohmann::ordered_json slow_drawing(const LivePreviewReport& report);

/// What became of the headset, in words and in order.
nlohmann::ordered_json headset_changes(const LivePreviewReport& report);

}  // namespace foveola
