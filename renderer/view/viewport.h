// The part of the sphere that a display shows: a pinhole view with head pose and field of view, and
// its visible part behind a headset's lenses.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/piecewise_constant.h"
#include "renderer/base/vec.h"

namespace foveola {

/// The visible part of a Viewport's plane, as a grid of equal cells.
class SeenPart {
 public:
  /// One row of cells per text, from the top; four cells per hexadecimal digit, the leftmost in its
  /// highest bit. Throws Error if this is not such a grid, or if no cell is visible.
  explicit SeenPart(std::vector<std::string> rows);

  /// The rows that it was made from.
  const std::vector<std::string>& rows() const { return rows_; }
  /// Visible share of the plane, in (0, 1].
  double share() const { return share_; }
  /// plane: (0, 0) is the display's top left corner, (1, 1) the bottom right one.
  bool contains(const Vec2& plane) const;
  /// Maps points of the unit square one to one to places on the plane, uniform over the visible
  /// part.
  Vec2 place(const Vec2& point) const;

 private:
  std::vector<std::string> rows_;
  Vec2 cells_;  ///< number of cells, horizontally and vertically
  PiecewiseConstant2D seen_;
  double share_;
};

/// Ratio of the distances from the lens' axis with and without the lens. d2: the latter squared.
inline double magnification(const RadialLens& lens, double d2) {
  return 1.0 + d2 * (lens.k1 + d2 * lens.k2);
}

/// Derivative of the distance with the lens by the one without. d2: the latter squared.
inline double growth(const RadialLens& lens, double d2) {
  return 1.0 + d2 * (3.0 * lens.k1 + d2 * 5.0 * lens.k2);
}

/// Viewport::sr_per_area, for a view with half_size() and lens().
inline double sr_per_area(const Vec2& half_size, const RadialLens& lens, const Vec2& plane) {
  const Vec2 offset = 2.0F * (plane - lens.axis) * half_size;
  const double d2 = glm::dot(offset, offset);
  const double larger = magnification(lens, d2);
  // Across the radius a patch grows by `larger`, along it by `growth`; at distance 1 it subtends
  // its area times cos^3.
  const double area = 4.0 * half_size.x * half_size.y * larger * growth(lens, d2);
  const double cosine = 1.0 / std::sqrt(1.0 + d2 * larger * larger);
  return area * cosine * cosine * cosine;
}

/// Converts a gaze (unit length, world) to the axes of a head that looks along `heading`; unit
/// length.
Vec3 gaze_in_head(const AzimuthElevation& heading, const Vec3& gaze);

/// Field of view across one side of a flat picture that is `ratio` times as long as a side which
/// spans fov_deg. Degrees, in (0, 180).
double fov_across_deg(double ratio, double fov_deg);

/// The properties of a view that do not depend on the head's orientation.
struct FieldOfView {
  double horizontal_deg = 100.0;  ///< in (0, 180), without the lens
  double vertical_deg = 100.0;    ///< in (0, 180), without the lens
  RadialLens lens;
  std::shared_ptr<const SeenPart> seen = nullptr;  ///< null: the whole plane
};

/// A rectilinear view behind a lens. Its image plane lies at distance 1 and is 2 tan(fov/2) wide
/// and high; fields of view exclude the lens.
class Viewport {
 public:
  /// Fields of view in radians. Throws Error unless each is in (0, pi), and for a lens that folds
  /// the display back on itself.
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
  /// The position of `direction` on the display; nullopt if it lies outside or behind.
  std::optional<Vec2> project(const Vec3& direction) const;
  /// Steradians per area of the display around `plane`; the whole display has area 1.
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

/// The view of a head with this orientation. Throws Error as Viewport does.
inline Viewport viewport_of(const Quat& head, const FieldOfView& field_of_view) {
  return {head, radians(field_of_view.horizontal_deg), radians(field_of_view.vertical_deg),
          field_of_view.lens};
}

}  // namespace foveola
