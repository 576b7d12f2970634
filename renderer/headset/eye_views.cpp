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

Mat3 part_from_canvas(const std::array<XrView, 2>& eyes, std::size_t eye, const Quat& head,
                      float distance_m) {
  const auto position_of = [](const XrView& one) {
    const XrVector3f& p = one.pose.position;
    return Vec3(p.x, p.y, p.z);
  };
  const auto size_of = [](const Sides& sides) {
    return Vec2(sides.right - sides.left, sides.up - sides.down);
  };
  // The canvas's middle is straight ahead, and its sides are as long as the left eye's picture's,
  // seen from the middle between the eyes.
  const Vec2 canvas_m = distance_m * size_of(sides_of(eyes[0].fov));
  const Mat3 head_from_canvas(Vec3(canvas_m.x, 0.0F, 0.0F), Vec3(0.0F, -canvas_m.y, 0.0F),
                              Vec3(-0.5F * canvas_m.x, 0.5F * canvas_m.y, -distance_m));
  const Quat eye_from_room = glm::conjugate(orientation_of(eyes[eye].pose));
  const Vec3 middle = 0.5F * (position_of(eyes[0]) + position_of(eyes[1]));
  Mat3 eye_from_canvas = glm::mat3_cast(eye_from_room * head) * head_from_canvas;
  eye_from_canvas[2] += eye_from_room * (middle - position_of(eyes[eye]));
  const Sides sides = sides_of(eyes[eye].fov);
  const Vec2 size = size_of(sides);
  const auto left = static_cast<float>(-sides.left);
  const auto up = static_cast<float>(sides.up);
  // What lies at (x, y, z) is seen at ((left + x / -z) / width, (up - y / -z) / height).
  const Mat3 part_from_eye(Vec3(1.0F / size.x, 0.0F, 0.0F), Vec3(0.0F, -1.0F / size.y, 0.0F),
                           Vec3(-left / size.x, -up / size.y, -1.0F));
  return part_from_eye * eye_from_canvas;
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
