// The head whose view a preview shows, from a recording, a headset or keys, and its camera in the
// scene.
#pragma once

#include <optional>

#include "renderer/gaze/head_tracker.h"
#include "renderer/headset/live_display.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/window/live/free_camera.h"

namespace foveola {

class PreviewHead {
 public:
  /// replayed: the poses of a recording, which begins now; empty: none. heading: initial direction,
  /// or straight ahead of a headset's wearer. display must outlive it.
  PreviewHead(const std::vector<HeadPose>& replayed, LiveDisplay& display,
              const AzimuthElevation& heading, const Clock& clock);

  HeadTracker& shown();
  /// The head turned by keys, shown or not.
  SteeredHeadTracker& steered() { return steered_; }
  FreeCamera camera_in(CameraSurroundings surroundings);

 private:
  SteeredHeadTracker steered_;
  std::optional<ScriptedHeadTracker> replayed_;
  std::optional<HeadsetHead> worn_;
};

/// The scene must outlive the result.
CameraSurroundings surroundings_of(const LoadedScene& loaded);

}  // namespace foveola
