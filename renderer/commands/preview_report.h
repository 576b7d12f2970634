// What the frames of a live preview were like: as text, and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/gaze/profiles.h"
#include "renderer/preview/live_frames.h"

namespace foveola {

struct PreviewRun {
  std::vector<LiveFrame> frames;  ///< at least one
  TrackerProfile tracker;
  DisplayProfile display;
  double refresh_rate_hz = 0.0;  ///< that frames aimed at
  bool is_resampled = false;     ///< whether frames were made into images for the display
  int threads = 0;
};

/// Tables, several lines.
std::string preview_text(const PreviewRun& run);

/// The same numbers, under "figures" in the units that they say, and under "latency" in ms.
nlohmann::ordered_json preview_json(const PreviewRun& run);

}  // namespace foveola
