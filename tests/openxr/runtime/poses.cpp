#include "tests/openxr/runtime/poses.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace foveola::test::openxr {

Pose operator*(const Pose& outer, const Pose& inner) {
  return {outer.orientation * inner.orientation,
          outer.position_m + outer.orientation * inner.position_m};
}

Pose inverse(const Pose& pose) {
  const glm::dquat back = glm::conjugate(pose.orientation);
  return {back, back * -pose.position_m};
}

glm::dquat rotation(const Turn& turn) {
  return glm::angleAxis(glm::radians(turn.yaw_deg), glm::dvec3(0.0, 1.0, 0.0)) *
         glm::angleAxis(glm::radians(turn.pitch_deg), glm::dvec3(1.0, 0.0, 0.0)) *
         glm::angleAxis(glm::radians(turn.roll_deg), glm::dvec3(0.0, 0.0, 1.0));
}

XrPosef to_xr(const Pose& pose) {
  const glm::quat q(pose.orientation);
  const glm::vec3 p(pose.position_m);
  return {{q.x, q.y, q.z, q.w}, {p.x, p.y, p.z}};
}

bool is_same(const XrPosef& a, const XrPosef& b) {
  constexpr double tolerance_m = 1e-4;
  constexpr double tolerance_deg = 0.01;
  const glm::dquat p(a.orientation.w, a.orientation.x, a.orientation.y, a.orientation.z);
  const glm::dquat q(b.orientation.w, b.orientation.x, b.orientation.y, b.orientation.z);
  const glm::dquat turn = glm::conjugate(p) * q;
  const double sine = glm::length(glm::dvec3(turn.x, turn.y, turn.z));
  const double turned_deg = glm::degrees(2.0 * std::atan2(sine, std::abs(turn.w)));
  const double moved_m = glm::length(glm::dvec3(
      a.position.x - b.position.x, a.position.y - b.position.y, a.position.z - b.position.z));
  return moved_m <= tolerance_m && turned_deg <= tolerance_deg;
}

}  // namespace foveola::test::openxr
