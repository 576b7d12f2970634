// Input of a headset's wearer, keys and gaze, through OpenXR's actions.
#pragma once

#include <optional>
#include <vector>

#include <openxr/openxr.h>

#include "renderer/headset/xr_instance.h"
#include "renderer/window/window_event.h"

namespace foveola {

/// An action set for one session, with bindings for known controllers and gamepads, and for the
/// gaze.
class HeadsetInputs {
 public:
  /// instance must outlive it; the session has no other actions yet, and is destroyed before it.
  /// Throws Error if the runtime refuses.
  HeadsetInputs(const XrInstanceOwner& instance, XrSession session);

  /// Polls the keys, and appends changes since the last call as events at `now`. While another
  /// program has the focus no key is pressed.
  void update(Nanoseconds now, std::vector<WindowEvent>& events);

  /// The space of the gaze as of the last update; nullopt while no eye tracker is active.
  std::optional<XrSpace> gaze_space() const;

 private:
  struct Button {
    XrAction action = XR_NULL_HANDLE;
    int key = 0;
    bool is_down = false;
  };

  /// The key of a stick pushed far enough; 0 if none is.
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
