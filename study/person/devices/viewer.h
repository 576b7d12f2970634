// Tracks the participant's head: worn tracker, or steering by keys, mouse and gamepad.
#pragma once

#include <optional>

#include "renderer/window/live/steering.h"

namespace foveola::study {

class Viewer {
 public:
  /// Looks straight ahead at first. pointer: receives the pointer's position, unless null. worn:
  /// the head's tracker, null if keys turn the head. Both must outlive it.
  explicit Viewer(PointerEyeTracker* pointer, HeadTracker* worn = nullptr)
      : pointer_(pointer), worn_(worn) {
    look_along({});
  }

  /// Turns the head at once and releases all held keys. References from head() become invalid.
  void look_along(const AzimuthElevation& heading);
  /// Sets the window's size and geometry from now on.
  void show(const ViewGeometry& geometry, const IVec2& framebuffer, double pixels_per_unit);
  /// sees_picture: false below a page, where keys must not turn the head but may be released.
  void follow(const WindowEvent& event, bool sees_picture);
  /// Turns towards a direction in the world. time: by the clock of the window's events.
  void turn_to(const Vec3& direction, Nanoseconds time);

  /// World from head.
  Quat orientation(Nanoseconds time) { return head().pose(time).orientation(); }
  HeadTracker& head() { return worn_ != nullptr ? *worn_ : neck_->head; }

 private:
  struct Neck {
    Neck(const AzimuthElevation& heading, PointerEyeTracker* pointer)
        : head(heading), steering(head, pointer) {}

    SteeredHeadTracker head;
    Steering steering;
  };
  struct Sight {
    ViewGeometry geometry;
    IVec2 framebuffer{1};
    double pixels_per_unit = 1.0;  ///< pixels per unit of the window's coordinates
  };

  PointerEyeTracker* pointer_;
  HeadTracker* worn_;
  std::optional<Neck> neck_;
  Sight sight_;
};

}  // namespace foveola::study
