// The participant's head, and what turns it.
#pragma once

#include <optional>

#include "renderer/window/live/steering.h"

namespace foveola::study {

class Viewer {
 public:
  /// Looks straight ahead at first. pointer: receives where the pointer is, if there is one. worn:
  /// what the head is tracked by, if it is not turned by keys. Both must outlive it.
  explicit Viewer(PointerEyeTracker* pointer, HeadTracker* worn = nullptr)
      : pointer_(pointer), worn_(worn) {
    look_along({});
  }

  /// At once; what is held no longer turns it. Whoever has head() has to ask for it again.
  void look_along(const AzimuthElevation& heading);
  /// How large the window is, and what it shows from now on.
  void show(const ViewGeometry& geometry, const IVec2& framebuffer, double pixels_per_unit);
  /// sees_picture: below a page, keys must not turn the head, but what was held may be let go.
  void follow(const WindowEvent& event, bool sees_picture);
  /// Turns to a direction of the world. time: by the clock of the window's events.
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
