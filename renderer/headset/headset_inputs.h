// What a headset's wearer presses, and where the eyes look, by OpenXR's actions.
#pragma once

#include <optional>
#include <vector>

#include <openxr/openxr.h>

#include "renderer/headset/xr_instance.h"
#include "renderer/window/window_event.h"

namespace foveola {

/// An action set for one session, with bindings for the controllers and gamepads that runtimes
/// know, and for the eyes.
class HeadsetInputs {
 public:
  /// instance must outlive it; the session is the one whose first actions these are, and is
  /// destroyed before it. Throws Error if the runtime refuses.
  HeadsetInputs(const XrInstanceOwner& instance, XrSession session);

  /// Asks what is pressed, and appends what changed since it was asked last as events of `now`.
  /// While another program has the focus nothing is pressed.
  void update(Nanoseconds now, std::vector<WindowEvent>& events);

  /// Where the eyes look; empty while no eye tracker is active, as of the last update.
  std::optional<XrSpace> gaze_space() const;

 private:
  struct Button {
    XrAction action = XR_NULL_HANDLE;
    int key = 0;
    bool is_down = false;
  };

  /// What a stick that is pushed far enough stands for; 0 if it is not.
  int key_of_stick() const;
  XrAction make_action(const char* name, const char* shown_name, XrActionType type) const;
  void suggest_bindings() const;
  bool is_pressed(XrAction action) const;
  bool is_gaze_active() const;

  const XrInstanceOwner* instance_;
  XrSession session_;
  XrActionSet set_ = XR_NULL_HANDLE;
  std::vector<Button> buttons_;
  XrAction stick_ = XR_NULL_HANDLE;
  XrAction gaze_ = XR_NULL_HANDLE;
  XrSpace gaze_space_ = XR_NULL_HANDLE;
  bool is_gaze_active_ = false;
};

}  // namespace foveola
