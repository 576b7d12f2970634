// What the mouse's buttons and the keys that are held with them mean for the camera.
#pragma once

#include <optional>

#include "renderer/base/vec.h"
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

}  // namespace foveola
