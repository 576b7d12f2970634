// The part of the sphere that a display shows: a pinhole view with a head pose and field of view.
#pragma once

#include <cmath>
#include <memory>
#include <optional>

#include "renderer/base/angles.h"
#include "renderer/base/radial_lens.h"
#include "renderer/view/seen_part.h"

namespace foveola {

/// A gaze (unit length, world) in the axes of a head that looks along `heading`; unit length.
Vec3 gaze_in_head(const AzimuthElevation& heading, const Vec3& gaze);

/// The field of view across one side of a flat picture that is `ratio` times as long as a side
/// which spans fov_deg. Degrees, in (0, 180).
double fov_across_deg(double ratio, double fov_deg);

/// What of a view stays the same while the head turns.
struct FieldOfView {
  double horizontal_deg = 100.0;  ///< in (0, 180), without the lens
  double vertical_deg = 100.0;    ///< in (0, 180), without the lens
  RadialLens lens;
  std::shared_ptr<const SeenPart> seen = nullptr;  ///< null: all of it
};

/// A view, rectilinear but for its lens. Its image plane lies at distance 1 and is 2 tan(fov/2)
/// wide and high: fields of view are those without the lens.
class Viewport {
 public:
  /// Fields of view in radians, each in (0, pi). Throws Error otherwise, and for a lens under which
  /// the display would fold back on itself.
  Viewport(const Quat& head, double horizontal_fov_rad, double vertical_fov_rad,
           const RadialLens& lens = {});
  /// The view of a head that looks along `heading`, with the horizon level. Throws Error as the
  /// other constructor does.
  Viewport(const AzimuthElevation& heading, const FieldOfView& field_of_view)
      : Viewport(head_orientation(heading), radians(field_of_view.horizontal_deg),
                 radians(field_of_view.vertical_deg), field_of_view.lens) {}

  /// plane: (0, 0) is the display's top left corner, (1, 1) the bottom right one. Unit length,
  /// world.
  Vec3 direction(const Vec2& plane) const {
    const Vec2 offset = 2.0F * (plane - lens_.axis) * half_size_;
    const float d2 = glm::dot(offset, offset);
    const Vec2 seen = (1.0F + d2 * (lens_.k1 + d2 * lens_.k2)) * offset;
    const Vec3 on_plane = forward_ + seen.x * right_ - seen.y * up_;
    return on_plane * (1.0F / std::sqrt(glm::dot(on_plane, on_plane)));
  }
  /// Where `direction` meets the view, or empty if it lies outside or behind.
  std::optional<Vec2> project(const Vec3& direction) const;
  /// The steradians of a patch of the display around `plane`, over its area, the whole display's
  /// being 1.
  double sr_per_area(const Vec2& plane) const;

  const Quat& head() const { return head_; }
  /// Half the width and height of the image plane at distance 1.
  const Vec2& half_size() const { return half_size_; }
  const RadialLens& lens() const { return lens_; }

  bool operator==(const Viewport&) const = default;

 private:
  Quat head_;
  Vec2 half_size_;
  RadialLens lens_;
  Vec3 right_;
  Vec3 up_;
  Vec3 forward_;
};

/// The view of a head with that orientation. Throws Error as Viewport does.
inline Viewport viewport_of(const Quat& head, const FieldOfView& field_of_view) {
  return {head, radians(field_of_view.horizontal_deg), radians(field_of_view.vertical_deg),
          field_of_view.lens};
}

}  // namespace foveola
