// Converts a point on a screen, where a tracker says that a person looks, to a direction of the
// view.
#pragma once

#include "renderer/base/vec.h"

namespace foveola {

/// A screen that a flat view fills. The eye that sees it undistorted is on the axis through its
/// middle, which is the head's -Z.
struct Screen {
  double width_m = 0.0;             ///< > 0
  double height_m = 0.0;            ///< > 0
  double horizontal_fov_deg = 0.0;  ///< field of view of what is shown on it, in (0, 180)
  double vertical_fov_deg = 0.0;    ///< vertical field of view, in (0, 180)
};

/// The direction in the head's axes, unit length, of the view's point at `fraction` of the screen's
/// width and height, from its top left corner rightwards and downwards. Points beyond the screen
/// (below 0, above 1) are on its plane.
Vec3 direction_at(const Screen& screen, const DVec2& fraction);

/// The fraction at a point that is so many metres right of and below the top left corner.
DVec2 fraction_of(const Screen& screen, const DVec2& metres);

}  // namespace foveola
