// Where a camera comes to stand around what it looks at, and how fast it goes.
#pragma once

#include "renderer/base/angles.h"
#include "renderer/gaze/steered_head_tracker.h"
#include "renderer/scene/scene.h"

namespace foveola {

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
