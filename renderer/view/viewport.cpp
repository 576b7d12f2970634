#include "renderer/view/viewport.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

float half_extent(double fov_rad) {
  if (!(fov_rad > 0.0 && fov_rad < std::numbers::pi)) {
    throw Error("field of view", fmt::format("{} degrees cannot be shown flat", degrees(fov_rad)),
                "choose one between 0 and 180 degrees");
  }
  return static_cast<float>(std::tan(0.5 * fov_rad));
}

}  // namespace

Quat head_orientation(const AzimuthElevation& heading) {
  // Positive azimuth turns from -Z towards +X, which about +Y is a negative rotation.
  const Quat turn = glm::angleAxis(static_cast<float>(-heading.azimuth_rad), Vec3(0, 1, 0));
  const Quat nod = glm::angleAxis(static_cast<float>(heading.elevation_rad), Vec3(1, 0, 0));
  return turn * nod;
}

Viewport::Viewport(const Quat& head, double horizontal_fov_rad, double vertical_fov_rad)
    : head_(head),
      half_size_(half_extent(horizontal_fov_rad), half_extent(vertical_fov_rad)),
      right_(head * Vec3(half_size_.x, 0.0F, 0.0F)),
      up_(head * Vec3(0.0F, half_size_.y, 0.0F)),
      forward_(head * Vec3(0.0F, 0.0F, -1.0F)) {}

std::optional<Vec2> Viewport::project(const Vec3& direction) const {
  const Vec3 local = glm::conjugate(head_) * direction;
  if (local.z >= 0.0F) {
    return std::nullopt;
  }
  const Vec2 plane(0.5F - 0.5F * local.x / (local.z * half_size_.x),
                   0.5F + 0.5F * local.y / (local.z * half_size_.y));
  const bool inside = plane.x >= 0.0F && plane.x <= 1.0F && plane.y >= 0.0F && plane.y <= 1.0F;
  return inside ? std::optional(plane) : std::nullopt;
}

double Viewport::solid_angle_sr() const {
  // Of a rectangle seen from above its centre (Mathar 2015, "Solid Angle of a Rectangular Plate").
  const double a = half_size_.x;
  const double b = half_size_.y;
  return 4.0 * std::atan(a * b / std::sqrt(1.0 + a * a + b * b));
}

}  // namespace foveola
