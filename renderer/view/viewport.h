// The part of the sphere that a display shows: a pinhole view with a head pose and field of view,
// and the part of it that is ever seen, since a headset's lenses show no corners.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/piecewise_constant.h"
#include "renderer/base/vec.h"

namespace foveola {

/// In cells of equal size over the display's plane, as a Viewport has it, each of which is seen or
/// not.
class SeenPart {
 public:
  /// A row of cells for each text, from the top, four cells in each hexadecimal digit, the leftmost
  /// one in its highest bit. Throws Error if that is no such grid, or nothing of it is seen.
  explicit SeenPart(std::vector<std::string> rows);

  /// What it was made of.
  const std::vector<std::string>& rows() const { return rows_; }
  /// How much of the plane is seen, in (0, 1].
  double share() const { return share_; }
  /// plane: (0, 0) is the display's top left corner, (1, 1) the bottom right one.
  bool contains(const Vec2& plane) const;
  /// Maps points of the unit square to places on the plane, uniform over what is seen, one to one.
  Vec2 place(const Vec2& point) const;

 private:
  std::vector<std::string> rows_;
  Vec2 cells_;  ///< how many beside each other, and one below the other
  PiecewiseConstant2D seen_;
  double share_;
};

/// How much larger the distance from the lens' axis is than the one on the display, squared: d2.
inline double magnification(const RadialLens& lens, double d2) {
  return 1.0 + d2 * (lens.k1 + d2 * lens.k2);
}

/// How fast the distance from the lens' axis grows with the one on the display, squared: d2.
inline double growth(const RadialLens& lens, double d2) {
  return 1.0 + d2 * (3.0 * lens.k1 + d2 * 5.0 * lens.k2);
}

/// Viewport::sr_per_area, of a view with half_size() and lens().
inline double sr_per_area(const Vec2& half_size, const RadialLens& lens, const Vec2& plane) {
  const Vec2 offset = 2.0F * (plane - lens.axis) * half_size;
  const double d2 = glm::dot(offset, offset);
  const double larger = magnification(lens, d2);
  // Across the radius a patch grows by `larger`, along it by `growth`; at distance 1 it is seen
  // under its area times cos^3.
  const double area = 4.0 * half_size.x * half_size.y * larger * growth(lens, d2);
  const double cosine = 1.0 / std::sqrt(1.0 + d2 * larger * larger);
  return area * cosine * cosine * cosine;
}

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
