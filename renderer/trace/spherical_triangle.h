// A triangle as a point sees it: its solid angle, and points that are uniform in it.
#pragma once

#include <numbers>

#include "renderer/base/lanes.h"
#include "renderer/base/turns.h"
#include "renderer/base/vec.h"
#include "renderer/trace/triangle.h"

namespace foveola {

/// One for each lane of a triangle and of a point that sees it, or single ones: Number is float or
/// Floats. Vectors are doubles: a needle's angles are differences of nearly equal ones. What is
/// computed from them is as exact as a float.
template <typename Number>
class SphericalTriangleOf {
 public:
  /// Seen from `viewpoint`. All that follows is finite for every finite triangle and viewpoint.
  SphericalTriangleOf(const TriangleOf<Number>& triangle, const Vec3Of<Number>& viewpoint)
      : a_(wide(triangle.p0) - wide(viewpoint)),
        b_(wide(triangle.p1) - wide(viewpoint)),
        c_(wide(triangle.p2) - wide(viewpoint)),
        normal_(cross(b_ - a_, c_ - a_)),
        length_a_(length(a_)),
        length_b_(length(b_)),
        length_c_(length(c_)) {
    const Wide numerator = magnitude(dot(normal_, a_));
    const Wide denominator = length_a_ * length_b_ * length_c_ + dot(a_, b_) * length_c_ +
                             dot(b_, c_) * length_a_ + dot(c_, a_) * length_b_;
    half_turns_ = turns_of(narrow(numerator), narrow(denominator));
  }

  /// In steradians, in [0, 2 pi]; one of the two on the plane (Van Oosterom and Strackee 1983, "The
  /// Solid Angle of a Plane Triangle").
  Number solid_angle() const { return (4.0F * std::numbers::pi_v<float>)*half_turns_; }

  /// The barycentric coordinates of a point whose direction is uniform in the solid angle (as Arvo
  /// 1995, "Stratified Sampling of Spherical Triangles", but with Peters' formula for the divided
  /// side: 2021, "BRDF Importance Sampling for Polygonal Lights"). u: in the unit square. The solid
  /// angle must not be 0.
  Vec2Of<Number> sample(const Vec2Of<Number>& u) const {
    const Vector a = (1.0 / length_a_) * a_;
    const Vector b = (1.0 / length_b_) * b_;
    const Vector c = (1.0 / length_c_) * c_;
    // The corner d on the side from a to c that leaves the share u.x of the solid angle in (a, b,
    // d). It is a's mirror image at some axis between a and c, x a + y c. The formula of the solid
    // angle, with d in place of c, is linear in x and y.
    const Wide triple = magnitude(dot(normal_, a)) / (length_b_ * length_c_);
    const SinesCosines<Number> half_angle = sine_cosine_of_turns(Number(u.x * half_turns_));
    const Wide sine = wide(half_angle.sine);
    const Wide cosine = wide(half_angle.cosine);
    const Vector axis =
        (cosine * triple - sine * dot(a + b, c)) * a + (sine * (1.0 + dot(a, b))) * c;
    const Wide squared_length = dot(axis, axis);
    const auto has_axis = squared_length > 0.0;
    const Wide twice = 2.0 * dot(axis, a) / (has_axis ? squared_length : Wide{} + 1.0);
    const Vector mirrored = twice * axis - a;
    const Vector d{has_axis ? mirrored.x : c.x, has_axis ? mirrored.y : c.y,
                   has_axis ? mirrored.z : c.z};

    // On the arc from b to d, uniform in the height over b.
    const Wide lowest = dot(d, b);
    const Wide height = 1.0 - wide(u.y) * (1.0 - lowest);
    const Wide squared_sine = 1.0 - lowest * lowest;
    const auto has_sine = squared_sine > 0.0;
    const Wide above = 1.0 - height * height;
    const Wide squared_along =
        (above > 0.0 ? above : Wide{}) / (has_sine ? squared_sine : Wide{} + 1.0);
    const Wide along = has_sine ? square_root(squared_along) : Wide{};
    return barycentric_of((height - along * lowest) * b + along * d);
  }

 private:
  using Wide = WideOf<Number>;
  struct Vector {
    Wide x, y, z;

    friend Vector operator+(const Vector& a, const Vector& b) {
      return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Vector operator-(const Vector& a, const Vector& b) {
      return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Vector operator*(const Wide& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
    friend Wide dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend Vector cross(const Vector& a, const Vector& b) {
      return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
    }
    friend Wide length(const Vector& v) { return square_root(dot(v, v)); }
  };

  static Vector wide(const Vec3Of<Number>& v) {
    return {foveola::wide(v.x), foveola::wide(v.y), foveola::wide(v.z)};
  }
  static Wide wide(const Number& x) { return foveola::wide(x); }
  static Wide in_unit_interval(const Wide& x, const Wide& most) {
    const Wide above = x > 0.0 ? x : Wide{};
    return above < most ? above : most;
  }

  Vec2Of<Number> barycentric_of(const Vector& direction) const {
    // Cramer's rule for direction * t = a + x * (b - a) + y * (c - a), times the determinant.
    const Wide determinant = dot(direction, normal_);
    const auto is_parallel = determinant == 0.0;
    const Wide inverse = 1.0 / (is_parallel ? Wide{} + 1.0 : determinant);
    const Vector moment = cross(a_, direction);
    const Wide x = in_unit_interval(dot(c_ - a_, moment) * inverse, Wide{} + 1.0);
    const Wide y = in_unit_interval(-dot(b_ - a_, moment) * inverse, 1.0 - x);
    const Wide third = Wide{} + 1.0 / 3.0;
    return {narrow(is_parallel ? third : x), narrow(is_parallel ? third : y)};
  }

  Vector a_, b_, c_;  ///< the corners, from the viewpoint
  Vector normal_;     ///< twice the area long
  Wide length_a_, length_b_, length_c_;
  Number half_turns_;  ///< half the solid angle as an angle, in turns
};
using SphericalTriangle = SphericalTriangleOf<float>;

}  // namespace foveola
