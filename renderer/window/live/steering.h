// Turns the head and points the gaze by keys, mouse and gamepad.
#pragma once

#include <optional>

#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/head_tracker.h"
#include "renderer/window/drawing/view_geometry.h"
#include "renderer/window/live/preview_controls.h"
#include "renderer/window/window_event.h"

namespace foveola {

/// The head's turn for a drag of this length, right and down: the picture follows the pointer like
/// a sheet of paper, and a drag across the first part turns by its field of view.
Turn turn_of_drag(const ViewGeometry& geometry, const DVec2& way_px);

class Steering {
 public:
  /// pointer_gaze: the tracker that follows the pointer, or null. Both must outlive it.
  Steering(SteeredHeadTracker& head, PointerEyeTracker* pointer_gaze)
      : head_(&head), pointer_gaze_(pointer_gaze) {}

  /// Sets the window's size and view.
  void show(const ViewGeometry& geometry, const IVec2& framebuffer, double pixels_per_unit);

  /// Ignores events that steer nothing.
  void follow(const WindowEvent& event);

  /// The pointer in the head's axes; nullopt outside the window.
  std::optional<Vec3> pointer() const;

 private:
  void steer(Nanoseconds time, const KeyMoved& key);
  void steer(Nanoseconds time, const GamepadMoved& gamepad);
  void steer(Nanoseconds time, const MouseButtonMoved& button);
  void steer(Nanoseconds time, const PointerMoved& moved);
  void turn_at_speed(Nanoseconds time);

  SteeredHeadTracker* head_;
  PointerEyeTracker* pointer_gaze_;
  ViewGeometry geometry_;
  IVec2 framebuffer_{1};
  double pixels_per_unit_ = 1.0;
  TurnKeys keys_;
  GamepadSticks sticks_;
  std::optional<DVec2> pointer_;  ///< pixels from the window's top left corner
  bool is_dragging_ = false;
};

}  // namespace foveola
