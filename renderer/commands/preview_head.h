// The head whose view a preview shows: that of a recording, the one in a headset, or one that keys
// turn.
#pragma once

#include <optional>

#include "renderer/commands/live_display.h"
#include "renderer/gaze/steered_head_tracker.h"
#include "renderer/window/free_camera.h"

namespace foveola {

class PreviewHead {
 public:
  /// replayed: the poses of a recording, which begins now; empty: there is none. heading: along
  /// which it looks at first, or whoever wears a headset and looks straight ahead. display must
  /// outlive it.
  PreviewHead(const std::vector<HeadPose>& replayed, LiveDisplay& display,
              const AzimuthElevation& heading, const Clock& clock);

  HeadTracker& shown();
  /// The one that keys turn, shown or not.
  SteeredHeadTracker& steered() { return steered_; }
  FreeCamera camera_in(CameraSurroundings surroundings);

 private:
  SteeredHeadTracker steered_;
  std::optional<ScriptedHeadTracker> replayed_;
  std::optional<HeadsetHead> worn_;
};

}  // namespace foveola
