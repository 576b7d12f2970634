// An OpenXR session: its states, spaces and frames.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/headset/headset_motion.h"
#include "renderer/headset/xr_instance.h"
#include "renderer/window/window_event.h"

namespace foveola {

/// The runtime's plan for a frame.
struct XrPlannedFrame {
  XrTime display_time = 0;  ///< middle of its display
  Nanoseconds interval{0};  ///< between frames
  bool is_drawn = false;    ///< whether any of it would be visible
};

/// For one thread, whose OpenGL context must be the one that it was created with.
class XrSessionOwner {
 public:
  /// Draws with the current GLX context. instance must outlive it. Throws Error if the runtime does
  /// not support that.
  explicit XrSessionOwner(const XrInstanceOwner& instance);
  ~XrSessionOwner();
  XrSessionOwner(const XrSessionOwner&) = delete;
  XrSessionOwner& operator=(const XrSessionOwner&) = delete;

  XrSession handle() const { return session_; }

  /// Handles events since the last call, and appends those that matter to others. Throws
  /// HeadsetLost if the session is lost.
  void follow_events(std::vector<HeadsetChange>& changes);
  /// Whether the session has frames.
  bool is_running() const { return is_running_; }
  /// Whether the lenses' hidden parts have changed since the last call.
  bool take_mask_change() { return std::exchange(has_mask_changed_, false); }
  /// Whether the runtime asks the program to end.
  bool is_over() const { return state_ == XR_SESSION_STATE_EXITING; }

  /// Waits until the next frame is due.
  XrPlannedFrame wait_for_frame() const;
  void begin_frame() const;
  /// views: in the room, the left eye's and the right eye's; empty: shows nothing.
  void end_frame(const XrPlannedFrame& frame,
                 std::span<const XrCompositionLayerProjectionView> views) const;

  /// The head's orientation in the room; nullopt if unknown.
  std::optional<Quat> head_at(XrTime time) const;
  /// The eyes' views in the room; nullopt if unknown.
  std::optional<std::array<XrView, 2>> eyes_at(XrTime time) const;
  /// The runtime's present answer on the gaze, in the head's axes. gaze: its action's space.
  ToldGaze gaze_at(Nanoseconds now, XrSpace gaze) const;

 private:
  void make_spaces();
  XrSpace make_space(XrReferenceSpaceType type) const;
  void follow_state(XrSessionState state, std::vector<HeadsetChange>& changes);
  void follow_presence(bool is_worn, std::vector<HeadsetChange>& changes);
  void begin();

  const XrInstanceOwner* instance_;
  XrSession session_ = XR_NULL_HANDLE;
  XrSpace room_ = XR_NULL_HANDLE;
  XrSpace head_ = XR_NULL_HANDLE;
  XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
  bool is_running_ = false;
  bool has_mask_changed_ = false;
  bool is_worn_ = true;  ///< as far as the runtime reports it
};

}  // namespace foveola
