#include "tests/openxr/runtime/poses.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace foveola::test::openxr {

Pose operator*(const Pose& outer, const Pose& inner) {
  return {outer.orientation * inner.orientation,
          outer.position + outer.orientation * inner.position};
}

Pose inverse(const Pose& pose) {
  const glm::dquat back = glm::conjugate(pose.orientation);
  return {back, back * -pose.position};
}

Pose turned(const Turn& turn, const glm::dvec3& position_m) {
  return {glm::angleAxis(glm::radians(turn.yaw_deg), glm::dvec3(0.0, 1.0, 0.0)) *
              glm::angleAxis(glm::radians(turn.pitch_deg), glm::dvec3(1.0, 0.0, 0.0)) *
              glm::angleAxis(glm::radians(turn.roll_deg), glm::dvec3(0.0, 0.0, 1.0)),
          position_m};
}

Pose pose_of(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  return {glm::normalize(glm::dquat(q.w, q.x, q.y, q.z)),
          glm::dvec3(pose.position.x, pose.position.y, pose.position.z)};
}

XrPosef for_application(const Pose& pose) {
  const glm::dquat& q = pose.orientation;
  return {{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
           static_cast<float>(q.w)},
          {static_cast<float>(pose.position.x), static_cast<float>(pose.position.y),
           static_cast<float>(pose.position.z)}};
}

bool is_valid(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  const double length = std::sqrt(static_cast<double>(q.x) * q.x + static_cast<double>(q.y) * q.y +
                                  static_cast<double>(q.z) * q.z + static_cast<double>(q.w) * q.w);
  return std::abs(length - 1.0) <= 0.01 && std::isfinite(pose.position.x) &&
         std::isfinite(pose.position.y) && std::isfinite(pose.position.z);
}

double metres_between(const Pose& a, const Pose& b) { return glm::length(a.position - b.position); }

double degrees_between(const Pose& a, const Pose& b) {
  const glm::dquat turn = glm::conjugate(a.orientation) * b.orientation;
  const double sine = glm::length(glm::dvec3(turn.x, turn.y, turn.z));
  return glm::degrees(2.0 * std::atan2(sine, std::abs(turn.w)));
}

}  // namespace foveola::test::openxr
