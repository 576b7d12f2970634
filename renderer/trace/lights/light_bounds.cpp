#include "renderer/trace/lights/light_bounds.h"

namespace foveola {
namespace {

using std::numbers::pi;

/// The smallest cone, up to rounding, that contains those of `a` and `b`.
void widen_cone(LightBounds& a, const LightBounds& b) {
  // The axis of two-sided lights is a line: take the nearer end.
  const bool flip = a.two_sided && b.two_sided && glm::dot(a.axis, b.axis) < 0.0;
  const DVec3 other = flip ? -b.axis : b.axis;
  const DVec3 across = glm::cross(a.axis, other);
  const double sine = glm::length(across);
  const double between = std::atan2(sine, glm::dot(a.axis, other));
  if (between + b.spread_rad <= a.spread_rad) {
    return;
  }
  if (between + a.spread_rad <= b.spread_rad) {
    a.axis = other;
    a.spread_rad = b.spread_rad;
    return;
  }
  const double spread = 0.5 * (a.spread_rad + between + b.spread_rad);
  if (spread >= pi || sine == 0.0) {
    a.spread_rad = pi;
    return;
  }
  // Turn the axis towards the other one, about their common perpendicular.
  const double turn = spread - a.spread_rad;
  const DVec3 perpendicular = glm::cross(across / sine, a.axis);
  a.axis = glm::normalize(std::cos(turn) * a.axis + std::sin(turn) * perpendicular);
  a.spread_rad = spread;
}

}  // namespace

LightBounds merge(const LightBounds& a, const LightBounds& b) {
  if (a.intensity == 0.0 || b.intensity == 0.0) {
    return a.intensity == 0.0 ? b : a;
  }
  LightBounds both = a;
  both.box.lower = glm::min(a.box.lower, b.box.lower);
  both.box.upper = glm::max(a.box.upper, b.box.upper);
  widen_cone(both, b);
  both.falloff_rad = std::max(a.falloff_rad, b.falloff_rad);
  both.two_sided = a.two_sided || b.two_sided;
  both.intensity = a.intensity + b.intensity;
  return both;
}

double orientation_measure(const LightBounds& bounds) {
  const double o = bounds.spread_rad;
  const double w = std::min(o + bounds.falloff_rad, pi);
  const double cone = 2.0 * pi * (1.0 - std::cos(o));
  const double rim =
      0.5 * pi *
      (2.0 * w * std::sin(o) - std::cos(o - 2.0 * w) - 2.0 * o * std::sin(o) + std::cos(o));
  return (bounds.two_sided ? 2.0 : 1.0) * (cone + rim);
}

}  // namespace foveola
