// Converts a gamepad's sticks to how fast the head turns.
#pragma once

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/steered_head_tracker.h"

namespace foveola {

/// Each stick's axes in [-1, 1], x rightwards and y downwards, as GLFW has them.
struct GamepadSticks {
  DVec2 left{0.0, 0.0};
  DVec2 right{0.0, 0.0};
};

/// What a stick does that is pushed so far from its middle, in whatever direction. The defaults are
/// chosen by judgement.
struct StickResponse {
  double dead_zone = 0.15;  ///< nothing up to here, where worn sticks rest; in [0, full_push)
  double full_push = 0.95;  ///< full speed from here on: not every stick reaches 1; in (0, 1]
  double exponent =
      2.0;  ///< exponent of the speed between, >= 1; above 1 it begins smoothly, for aiming
  double full_speed_rad_per_s = radians(120.0);  ///< >= 0
};

/// How fast the head turns: either stick turns it, and both together no faster than one. Sticks
/// whose axes are no numbers count as at rest.
TurnSpeed turn_speed(const GamepadSticks& sticks, const StickResponse& response);

}  // namespace foveola
