// The visual field's axes: right of, above and along the gaze.
#pragma once

#include <cmath>

#include "renderer/base/vec.h"

namespace foveola {

/// Right, up and ahead of a gaze. Up is the head's up, projected at the gaze.
struct GazeFrame {
  Vec3 right{1.0F, 0.0F, 0.0F};
  Vec3 up{0.0F, 1.0F, 0.0F};
  Vec3 ahead{0.0F, 0.0F, -1.0F};

  GazeFrame() = default;
  /// gaze: unit length, world. head: maps the head's axes (-Z forward) to the world.
  GazeFrame(const Vec3& gaze, const Quat& head) : ahead(gaze) {
    const Vec3 head_up = head * Vec3(0.0F, 1.0F, 0.0F);
    const float along = glm::dot(head_up, gaze);
    up = head_up - along * gaze;
    constexpr float smallest_squared_length = 1e-6F;
    if (glm::dot(up, up) < smallest_squared_length) {
      // For a gaze along the head's up axis, the back of the head is above.
      const Vec3 back = head * Vec3(0.0F, 0.0F, std::copysign(1.0F, along));
      up = back - glm::dot(back, gaze) * gaze;
    }
    up = glm::normalize(up);
    right = glm::cross(ahead, up);
  }

  /// local: right, up, ahead.
  Vec3 to_world(const Vec3& local) const {
    return local.x * right + local.y * up + local.z * ahead;
  }
  Vec3 to_local(const Vec3& world) const {
    return {glm::dot(world, right), glm::dot(world, up), glm::dot(world, ahead)};
  }
};

}  // namespace foveola
