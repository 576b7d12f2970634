// Summarises a live preview's frames, as text and as JSON.
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
  double refresh_rate_hz = 0.0;  ///< the frames' target rate
  bool is_resampled = false;     ///< whether frames were resampled for the display
  int threads = 0;
};

/// Tables over several lines.
std::string preview_text(const PreviewRun& run);

/// The numbers of preview_text: under "figures" in the units that they name, under "latency" in ms.
nlohmann::ordered_json preview_json(const PreviewRun& run);

}  // namespace foveola
