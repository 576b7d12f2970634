#include "renderer/view/viewport.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/view/display_plane.h"

namespace foveola {
namespace {

float half_extent(double fov_rad) {
  if (!(fov_rad > 0.0 && fov_rad < std::numbers::pi)) {
    throw Error("field of view", fmt::format("{} degrees cannot be shown flat", degrees(fov_rad)),
                "choose one between 0 and 180 degrees");
  }
  return static_cast<float>(std::tan(0.5 * fov_rad));
}

/// The squared distance from the lens' axis to the display's furthest corner.
double furthest_d2(const RadialLens& lens, const Vec2& half_size) {
  const Vec2 to_corner = 2.0F * glm::max(lens.axis, 1.0F - lens.axis) * half_size;
  return glm::dot(to_corner, to_corner);
}

const RadialLens& checked(const RadialLens& lens, const Vec2& half_size) {
  constexpr int steps = 64;
  const double furthest = furthest_d2(lens, half_size);
  bool rises = std::isfinite(lens.axis.x) && std::isfinite(lens.axis.y);
  for (int i = 0; i <= steps; ++i) {
    rises = rises && growth(lens, furthest * i / steps) > 0.0;
  }
  if (!rises) {
    throw Error("lens",
                fmt::format("k1 = {}, k2 = {} fold the display's corners back", lens.k1, lens.k2),
                "choose coefficients under which the distance from the axis grows to the corners");
  }
  return lens;
}

/// The distance on the display that is seen at `distance`; `furthest` bounds it.
double on_display(const RadialLens& lens, double distance, double furthest) {
  double low = 0.0;
  double high = furthest;
  double d = std::min(distance, high);
  constexpr int most_steps = 60;
  for (int step = 0; step < most_steps; ++step) {
    const double excess = d * magnification(lens, d * d) - distance;
    (excess > 0.0 ? high : low) = d;
    const double newton = d - excess / growth(lens, d * d);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (next == d) {
      break;
    }
    d = next;
  }
  return d;
}

}  // namespace

double fov_across_deg(double ratio, double fov_deg) {
  return degrees(2.0 * std::atan(ratio * std::tan(0.5 * radians(fov_deg))));
}

Vec3 gaze_in_head(const AzimuthElevation& heading, const Vec3& gaze) {
  return glm::normalize(glm::conjugate(head_orientation(heading)) * gaze);
}

Viewport::Viewport(const Quat& head, double horizontal_fov_rad, double vertical_fov_rad,
                   const RadialLens& lens)
    : head_(head),
      half_size_(half_extent(horizontal_fov_rad), half_extent(vertical_fov_rad)),
      lens_(checked(lens, half_size_)),
      right_(head * Vec3(1.0F, 0.0F, 0.0F)),
      up_(head * Vec3(0.0F, 1.0F, 0.0F)),
      forward_(head * Vec3(0.0F, 0.0F, -1.0F)) {}

std::optional<Vec2> Viewport::project(const Vec3& direction) const {
  const Vec3 local = glm::conjugate(head_) * direction;
  if (local.z >= 0.0F) {
    return std::nullopt;
  }
  Vec2 offset = Vec2(local.x, -local.y) / -local.z;
  if (lens_.k1 != 0.0F || lens_.k2 != 0.0F) {
    const double distance = glm::length(offset);
    const double furthest = std::sqrt(furthest_d2(lens_, half_size_));
    if (distance > furthest * magnification(lens_, furthest * furthest)) {
      return std::nullopt;
    }
    const double display = on_display(lens_, distance, furthest);
    offset *= distance > 0.0 ? static_cast<float>(display / distance) : 1.0F;
  }
  const Vec2 plane = lens_.axis + 0.5F * offset / half_size_;
  const bool inside = plane.x >= 0.0F && plane.x <= 1.0F && plane.y >= 0.0F && plane.y <= 1.0F;
  return inside ? std::optional(plane) : std::nullopt;
}

double Viewport::sr_per_area(const Vec2& plane) const {
  return foveola::sr_per_area(half_size_, lens_, plane);
}

}  // namespace foveola
