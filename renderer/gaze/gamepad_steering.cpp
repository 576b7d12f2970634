#include "renderer/gaze/gamepad_steering.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace foveola {
namespace {

/// What a stick asks for, rightwards and downwards, as a part of full speed: at most 1 long.
DVec2 part_asked_for(const DVec2& stick, const StickResponse& response) {
  const double push = glm::length(stick);
  const double travel = (push - response.dead_zone) / (response.full_push - response.dead_zone);
  if (!(travel > 0.0)) {
    return DVec2(0.0);
  }
  return std::pow(std::min(travel, 1.0), response.exponent) / push * stick;
}

}  // namespace

TurnSpeed turn_speed(const GamepadSticks& sticks, const StickResponse& response) {
  assert(response.dead_zone >= 0.0 && response.dead_zone < response.full_push);
  const DVec2 asked =
      part_asked_for(sticks.left, response) + part_asked_for(sticks.right, response);
  const DVec2 part = asked / std::max(1.0, glm::length(asked));
  return {.right_rad_per_s = response.full_speed_rad_per_s * part.x,
          .up_rad_per_s = -response.full_speed_rad_per_s * part.y};
}

}  // namespace foveola
