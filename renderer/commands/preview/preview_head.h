// The head whose view a preview shows, of a recording, a headset or keys, and the scene in which it
// moves.
#pragma once

#include <optional>

#include "renderer/gaze/head_tracker.h"
#include "renderer/headset/live_display.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/window/live/free_camera.h"

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

/// They refer to the scene, which must outlive them.
CameraSurroundings surroundings_of(const LoadedScene& loaded);

}  // namespace foveola
