// A session of OpenXR: its states, its spaces and its frames.
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

/// A frame as the runtime plans it.
struct XrPlannedFrame {
  XrTime display_time = 0;  ///< the middle of the time that it will be seen
  Nanoseconds interval{0};  ///< from one frame to the next
  bool is_drawn = false;    ///< whether anything of it would be seen
};

/// One thread uses it, whose OpenGL context must be the one that it was made with.
class XrSessionOwner {
 public:
  /// Draws with the OpenGL context of GLX that is current. instance must outlive it. Throws Error
  /// if the runtime cannot do that.
  explicit XrSessionOwner(const XrInstanceOwner& instance);
  ~XrSessionOwner();
  XrSessionOwner(const XrSessionOwner&) = delete;
  XrSessionOwner& operator=(const XrSessionOwner&) = delete;

  XrSession handle() const { return session_; }

  /// Follows what happened since it was asked last, and appends what of it matters to others.
  /// Throws HeadsetLost if the session is lost.
  void follow_events(std::vector<HeadsetChange>& changes);
  /// Whether there are frames to be had.
  bool is_running() const { return is_running_; }
  /// Whether what the lenses never show has changed since it was asked last.
  bool take_mask_change() { return std::exchange(has_mask_changed_, false); }
  /// Whether the runtime wants the program to end.
  bool is_over() const { return state_ == XR_SESSION_STATE_EXITING; }

  /// Waits until it is time for the next frame.
  XrPlannedFrame wait_for_frame() const;
  void begin_frame() const;
  /// views: in the room, the left eye's and the right eye's; none: nothing is shown.
  void end_frame(const XrPlannedFrame& frame,
                 std::span<const XrCompositionLayerProjectionView> views) const;

  /// The head's orientation in the room; empty where it is not known.
  std::optional<Quat> head_at(XrTime time) const;
  /// The eyes' views in the room; empty where they are not known.
  std::optional<std::array<XrView, 2>> eyes_at(XrTime time) const;
  /// What is told of the gaze now, in the head's axes. gaze: its action's space.
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
  bool is_worn_ = true;  ///< as far as the runtime tells it
};

}  // namespace foveola
