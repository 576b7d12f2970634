// Places and directions in space.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <openxr/openxr.h>

namespace foveola::test::openxr {

/// Where a thing is in a space, and how it is turned: forward is -z, up y.
struct Pose {
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 position_m{0.0};
};

/// The pose in the outer space of what `inner` is in the space that `outer` places.
Pose operator*(const Pose& outer, const Pose& inner);
Pose inverse(const Pose& pose);

/// To the left by the yaw, then up by the pitch, then tilted to the left by the roll.
struct Turn {
  double yaw_deg = 0.0;
  double pitch_deg = 0.0;
  double roll_deg = 0.0;
};
glm::dquat rotation(const Turn& turn);

XrPosef to_xr(const Pose& pose);

/// Whether poses agree as closely as an application computes that uses float.
bool is_same(const XrPosef& a, const XrPosef& b);

}  // namespace foveola::test::openxr
