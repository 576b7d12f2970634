#include "renderer/trace/spherical_triangle.h"

#include <algorithm>
#include <cmath>

namespace foveola {

SphericalTriangle::SphericalTriangle(const TriangleOf<float>& triangle, const Vec3& viewpoint)
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
  solid_angle_ = 2.0F * std::atan2(static_cast<float>(numerator), static_cast<float>(denominator));
}

Vec2 SphericalTriangle::sample(const Vec2& u) const {
  const DVec3 a = a_ / length_a_;
  const DVec3 b = b_ / length_b_;
  const DVec3 c = c_ / length_c_;
  // The corner d on the side from a to c that leaves the share u.x of the solid angle in (a, b, d).
  // It is a's mirror image at some axis between a and c, x a + y c. The formula of the solid angle,
  // with d in place of c, is linear in x and y.
  const double triple = std::abs(glm::dot(normal_, a)) / (length_b_ * length_c_);
  const float half_angle = 0.5F * u.x * solid_angle_;
  const double sine = std::sin(half_angle);
  const double cosine = std::cos(half_angle);
  const DVec3 axis =
      (cosine * triple - sine * glm::dot(a + b, c)) * a + sine * (1.0 + glm::dot(a, b)) * c;
  const double squared_length = glm::dot(axis, axis);
  const DVec3 d = squared_length > 0.0 ? (2.0 * glm::dot(axis, a) / squared_length) * axis - a : c;

  // On the arc from b to d, uniform in the height over b.
  const double lowest = glm::dot(d, b);
  const double height = 1.0 - u.y * (1.0 - lowest);
  const double squared_sine = 1.0 - lowest * lowest;
  const double along =
      squared_sine > 0.0 ? std::sqrt(std::max(0.0, 1.0 - height * height) / squared_sine) : 0.0;
  return barycentric_of((height - along * lowest) * b + along * d);
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
