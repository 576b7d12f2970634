// Moves of the camera: orbits and speeds, and what the mouse's buttons and keys mean for them.
#pragma once

#include <optional>

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/head_tracker.h"
#include "renderer/scene/scene.h"
#include "renderer/window/window_event.h"

namespace foveola {

/// What moving the mouse does, by the button that is held.
enum class Drag {
  none,
  turn,   ///< the left one
  orbit,  ///< the middle one, or the left one with Alt
  fly     ///< the right one: as turn, while letters move the camera
};

/// Follows the mouse through a window's events.
class MouseDrags {
 public:
  /// pixels_per_unit: of the window's coordinates.
  void show(double pixels_per_unit) { pixels_per_unit_ = pixels_per_unit; }

  /// How far the pointer went in pixels, right and down; zero unless it is being dragged.
  DVec2 follow(const PointerMoved& moved);

  /// Where the left button was pressed and let go again without a drag, in pixels from the window's
  /// top left; empty if it was not.
  std::optional<DVec2> follow(const MouseButtonMoved& button, bool holds_alt);

  /// What goes on.
  Drag drag() const { return drag_; }

 private:
  double pixels_per_unit_ = 1.0;
  std::optional<DVec2> pointer_;  ///< pixels
  Drag drag_ = Drag::none;
  int button_ = 0;       ///< the one that is held, while something is dragged
  double way_px_ = 0.0;  ///< how far the pointer went since it is held
};

/// Where a camera stands, and where it looks.
struct Standing {
  Vec3 position{0.0F};  ///< in the scene's coordinates
  AzimuthElevation heading;
};

/// Turns the camera, and moves it so that `pivot` stays in its place in the view and at its
/// distance. The elevation stops at the zenith and at the nadir.
Standing orbited(const Standing& standing, const Vec3& pivot, const Turn& turn);

/// The speed at which a space so many metres wide is walked through in ten seconds, in metres a
/// second; 1 if it has no size.
double walking_speed(double width_m);

}  // namespace foveola
