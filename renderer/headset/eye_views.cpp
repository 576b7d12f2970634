#include "renderer/headset/eye_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foveola {
namespace {

/// Where a view's sides are on the plane at distance 1.
struct Sides {
  double left = 0.0;
  double right = 0.0;
  double up = 0.0;
  double down = 0.0;
};

Sides sides_of(const XrFovf& fov) {
  return {.left = std::tan(fov.angleLeft),
          .right = std::tan(fov.angleRight),
          .up = std::tan(fov.angleUp),
          .down = std::tan(fov.angleDown)};
}

FieldOfView field_of_view_between(const Sides& sides) {
  const double width = sides.right - sides.left;
  const double height = sides.up - sides.down;
  return {.horizontal_deg = degrees(2.0 * std::atan(0.5 * width)),
          .vertical_deg = degrees(2.0 * std::atan(0.5 * height)),
          .lens = {.axis = {static_cast<float>(-sides.left / width),
                            static_cast<float>(sides.up / height)}}};
}

}  // namespace

FieldOfView field_of_view_of(const XrFovf& fov) { return field_of_view_between(sides_of(fov)); }

Viewport viewport_of(const XrView& eye, const Quat& world_from_room) {
  return viewport_of(world_from_room * orientation_of(eye.pose), field_of_view_of(eye.fov));
}

Vec2 straight_ahead_of(const std::array<XrView, 2>& eyes, std::size_t eye, const Quat& head,
                       float distance_m) {
  const auto position_of = [](const XrView& one) {
    const XrVector3f& p = one.pose.position;
    return Vec3(p.x, p.y, p.z);
  };
  const Vec3 middle = 0.5F * (position_of(eyes[0]) + position_of(eyes[1]));
  const Vec3 point = middle + head * Vec3(0.0F, 0.0F, -distance_m);
  const Viewport view = viewport_of(eyes[eye], Quat(1.0F, 0.0F, 0.0F, 0.0F));
  return view.project(glm::normalize(point - position_of(eyes[eye]))).value_or(view.lens().axis);
}

FieldOfView field_of_view_of_both(const std::array<XrView, 2>& eyes, const Quat& head) {
  const double farthest = std::tan(radians(80.0));
  constexpr double unknown = std::numeric_limits<double>::infinity();
  Sides both{.left = unknown, .right = -unknown, .up = -unknown, .down = unknown};
  for (const XrView& eye : eyes) {
    const Quat head_from_eye = glm::conjugate(head) * orientation_of(eye.pose);
    const Sides sides = sides_of(eye.fov);
    for (const double x : {sides.left, sides.right}) {
      for (const double y : {sides.up, sides.down}) {
        const Vec3 corner = head_from_eye * Vec3(static_cast<float>(x), static_cast<float>(y), -1);
        const auto on_plane = [&](float along) {
          const double distance = std::max(-static_cast<double>(corner.z), 1e-6);
          return std::clamp(along / distance, -farthest, farthest);
        };
        both.left = std::min(both.left, on_plane(corner.x));
        both.right = std::max(both.right, on_plane(corner.x));
        both.up = std::max(both.up, on_plane(corner.y));
        both.down = std::min(both.down, on_plane(corner.y));
      }
    }
  }
  return field_of_view_between(both);
}

}  // namespace foveola
