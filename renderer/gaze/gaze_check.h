// A check of the tracker amid a session: how good it is, and what is corrected from then on.
#pragma once

#include <optional>
#include <span>

#include "renderer/gaze/gaze_correction.h"
#include "renderer/gaze/gaze_quality.h"

namespace foveola {

struct GazeCheck {
  GazeQuality quality;
  std::optional<GazeCorrection> correction;  ///< that the tracker corrects by since then, if any
};

/// Judges the tracker by targets that were looked at, at least one, as `tracker` saw them.
/// corrects: whether it corrects from now on what they tell, if they tell enough.
GazeCheck check_gaze(std::span<const WatchedTarget> watched, bool corrects,
                     CorrectedEyeTracker& tracker);

}  // namespace foveola
