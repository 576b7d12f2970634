// Places and directions in space.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

/// Where a thing is in a space, and how it is turned: forward is -z, up y.
struct Pose {
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 position{0.0};  ///< m
};

/// Of what `inner` tells in a space that `outer` places in another.
Pose operator*(const Pose& outer, const Pose& inner);
Pose inverse(const Pose& pose);

/// Turned to the left by the yaw, then up by the pitch, then tilted to the left by the roll.
struct Turn {
  double yaw_deg = 0.0;
  double pitch_deg = 0.0;
  double roll_deg = 0.0;
};
Pose turned(const Turn& turn, const glm::dvec3& position_m = glm::dvec3(0.0));

Pose pose_of(const XrPosef& pose);
XrPosef for_application(const Pose& pose);
/// Finite, its quaternion of length 1 within 1%.
bool is_valid(const XrPosef& pose);

double metres_between(const Pose& a, const Pose& b);
double degrees_between(const Pose& a, const Pose& b);

}  // namespace foveola::test::openxr
