#include "renderer/trace/spherical_triangle.h"

#include <algorithm>
#include <cmath>

namespace foveola {
namespace {

/// The unit vector of the part of `v` that is perpendicular to the unit vector `axis`; zero if
/// there is none.
DVec3 perpendicular_part(const DVec3& v, const DVec3& axis) {
  const DVec3 part = v - glm::dot(v, axis) * axis;
  const double length = glm::length(part);
  return length > 0.0 ? part / length : DVec3(0.0);
}

double sine_of(double cosine) { return std::sqrt(std::max(0.0, 1.0 - cosine * cosine)); }

}  // namespace

SphericalTriangle::SphericalTriangle(const Triangle& triangle, const Vec3& viewpoint)
    : a_(DVec3(triangle.p0) - DVec3(viewpoint)),
      b_(DVec3(triangle.p1) - DVec3(viewpoint)),
      c_(DVec3(triangle.p2) - DVec3(viewpoint)),
      normal_(glm::cross(b_ - a_, c_ - a_)),
      length_a_(glm::length(a_)),
      length_b_(glm::length(b_)),
      length_c_(glm::length(c_)) {
  const double numerator = std::abs(glm::dot(normal_, a_));
  const double denominator = length_a_ * length_b_ * length_c_ + glm::dot(a_, b_) * length_c_ +
                             glm::dot(b_, c_) * length_a_ + glm::dot(c_, a_) * length_b_;
  solid_angle_ = 2.0 * std::atan2(numerator, denominator);
}

Vec2 SphericalTriangle::sample(const Vec2& u) const {
  const DVec3 a = a_ / length_a_;
  const DVec3 b = b_ / length_b_;
  const DVec3 c = c_ / length_c_;
  // The angle alpha at a, between the planes of its two sides.
  const DVec3 plane_ab = glm::cross(a, b);
  const DVec3 plane_ac = glm::cross(a, c);
  const double scale = 1.0 / (glm::length(plane_ab) * glm::length(plane_ac));
  const double cos_alpha = glm::dot(plane_ab, plane_ac) * scale;
  const double sin_alpha = std::abs(glm::dot(plane_ab, c)) * scale;

  // The corner d on the side from a to c that leaves the share u.x of the area in (a, b, d).
  const double area = u.x * solid_angle_;
  const double sin_area = std::sin(area);
  const double cos_area = std::cos(area);
  const double s = sin_area * cos_alpha - cos_area * sin_alpha;
  const double t = cos_area * cos_alpha + sin_area * sin_alpha;
  const double p = t - cos_alpha;
  const double q = s + sin_alpha * glm::dot(a, b);
  const double divisor = (q * s + p * t) * sin_alpha;
  const double cos_ad =
      divisor == 0.0 ? 1.0 : std::clamp(((q * t - p * s) * cos_alpha - q) / divisor, -1.0, 1.0);
  const DVec3 d = cos_ad * a + sine_of(cos_ad) * perpendicular_part(c, a);

  // On the arc from b to d, uniform in the height over b.
  const double height = 1.0 - u.y * (1.0 - glm::dot(d, b));
  return barycentric_of(height * b + sine_of(height) * perpendicular_part(d, b));
}

Vec2 SphericalTriangle::barycentric_of(const DVec3& direction) const {
  // Cramer's rule for direction * t = a + x * (b - a) + y * (c - a), times the determinant.
  const double determinant = glm::dot(direction, normal_);
  if (determinant == 0.0) {
    return Vec2(1.0F / 3.0F);
  }
  const DVec3 moment = glm::cross(a_, direction);
  const double x = std::clamp(glm::dot(c_ - a_, moment) / determinant, 0.0, 1.0);
  const double y = std::clamp(glm::dot(b_ - a_, moment) / -determinant, 0.0, 1.0 - x);
  return {x, y};
}

}  // namespace foveola
