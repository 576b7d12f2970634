#include "renderer/commands/preview_head.h"

#include <utility>

#include "renderer/gaze/recorded_head.h"

namespace foveola {

PreviewHead::PreviewHead(const std::vector<HeadPose>& replayed, LiveDisplay& display,
                         const AzimuthElevation& heading, const Clock& clock)
    : steered_(heading) {
  if (!replayed.empty()) {
    replayed_.emplace(replayed_head(replayed, clock.now()));
  } else if (display.headset() != nullptr) {
    worn_.emplace(display.headset()->motion());
    worn_->face(heading);
  }
}

HeadTracker& PreviewHead::shown() {
  if (replayed_) {
    return *replayed_;
  }
  return worn_ ? static_cast<HeadTracker&>(*worn_) : steered_;
}

FreeCamera PreviewHead::camera_in(CameraSurroundings surroundings) {
  if (replayed_) {
    return {std::move(surroundings), *replayed_, "a recording"};
  }
  if (worn_) {
    return {std::move(surroundings), *worn_, "the headset"};
  }
  return {std::move(surroundings), steered_};
}

}  // namespace foveola
