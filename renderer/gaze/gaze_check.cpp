#include "renderer/gaze/gaze_check.h"

namespace foveola {

GazeCheck check_gaze(std::span<const WatchedTarget> watched, bool corrects,
                     CorrectedEyeTracker& tracker) {
  GazeCheck check{.quality = gaze_quality(watched), .correction = std::nullopt};
  if (corrects) {
    check.correction = fit_correction(check.quality.targets);
  }
  if (check.correction) {
    tracker.add(*check.correction);
  }
  return check;
}

}  // namespace foveola
