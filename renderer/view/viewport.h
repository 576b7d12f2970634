// The part of the sphere that a display shows: a pinhole view with a head pose and field of view.
#pragma once

#include <cmath>
#include <optional>

#include "renderer/base/angles.h"

namespace foveola {

/// The orientation that looks along `heading` with the horizon level: it maps the head's axes
/// (+X right, +Y up, -Z forward) to the world.
Quat head_orientation(const AzimuthElevation& heading);

/// A rectilinear view. Its image plane lies at distance 1 and is 2 tan(fov/2) wide and high.
class Viewport {
 public:
  /// Fields of view in radians, each in (0, pi). Throws Error otherwise.
  Viewport(const Quat& head, double horizontal_fov_rad, double vertical_fov_rad);

  /// plane: (0, 0) is the top left corner, (1, 1) the bottom right one. Unit length, world.
  Vec3 direction(const Vec2& plane) const {
    const Vec3 on_plane =
        forward_ + (2.0F * plane.x - 1.0F) * right_ + (1.0F - 2.0F * plane.y) * up_;
    return on_plane * (1.0F / std::sqrt(glm::dot(on_plane, on_plane)));
  }
  /// Where `direction` meets the view, or empty if it lies outside or behind.
  std::optional<Vec2> project(const Vec3& direction) const;
  /// Steradians of the whole view.
  double solid_angle_sr() const;

  const Quat& head() const { return head_; }
  /// Half the width and height of the image plane at distance 1.
  const Vec2& half_size() const { return half_size_; }

 private:
  Quat head_;
  Vec2 half_size_;
  // From the eye to the middle of the image plane, and from there to its right and upper edge.
  Vec3 right_;
  Vec3 up_;
  Vec3 forward_;
};

}  // namespace foveola
