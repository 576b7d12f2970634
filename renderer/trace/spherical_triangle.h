// A triangle as a point sees it: its solid angle, and points that are uniform in it.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/trace/triangle.h"

namespace foveola {

/// Vectors are doubles: a needle's angles are differences of nearly equal ones. What is computed
/// from them is as exact as a float.
class SphericalTriangle {
 public:
  /// Seen from `viewpoint`. All that follows is finite for every finite triangle and viewpoint.
  SphericalTriangle(const TriangleOf<float>& triangle, const Vec3& viewpoint);

  /// In steradians, in [0, 2 pi]; one of the two on the plane (Van Oosterom and Strackee 1983, "The
  /// Solid Angle of a Plane Triangle").
  float solid_angle() const { return solid_angle_; }

  /// The barycentric coordinates of a point whose direction is uniform in the solid angle (as Arvo
  /// 1995, "Stratified Sampling of Spherical Triangles", but with Peters' formula for the divided
  /// side: 2021, "BRDF Importance Sampling for Polygonal Lights"). u: in the unit square. The solid
  /// angle must not be 0.
  Vec2 sample(const Vec2& u) const;

 private:
  Vec2 barycentric_of(const DVec3& direction) const;

  DVec3 a_, b_, c_;  ///< the corners, from the viewpoint
  DVec3 normal_;     ///< twice the area long
  double length_a_, length_b_, length_c_;
  float solid_angle_;
};

}  // namespace foveola
