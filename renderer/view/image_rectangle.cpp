#include "renderer/view/image_rectangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "renderer/base/angles.h"

namespace foveola {
namespace {

using std::numbers::pi;

/// Widens [low, high] by the elevations of the great circle's arc from a to b, less than half of
/// it.
void add_arc(const DVec3& a, const DVec3& b, double& low_rad, double& high_rad) {
  const auto add = [&](const DVec3& direction) {
    const double elevation = std::asin(std::clamp(direction.y, -1.0, 1.0));
    low_rad = std::min(low_rad, elevation);
    high_rad = std::max(high_rad, elevation);
  };
  add(a);
  add(b);
  // The circle's highest point, and its lowest opposite, count where they lie between a and b.
  const DVec3 axis = glm::normalize(glm::cross(a, b));
  const DVec3 highest = DVec3(0.0, 1.0, 0.0) - axis.y * axis;
  for (const double sign : {1.0, -1.0}) {
    const DVec3 extreme = sign * highest;
    const bool is_after_a = glm::dot(glm::cross(a, extreme), axis) > 0.0;
    const bool is_before_b = glm::dot(glm::cross(extreme, b), axis) > 0.0;
    if (is_after_a && is_before_b) {
      add(glm::normalize(extreme));
    }
  }
}

/// Directions along the view's edge, clockwise from its top left corner. From one to the next lead
/// great circles; under a lens edges are bowed, and many short ones stand for them.
std::vector<DVec3> outline(const Viewport& viewport) {
  const int steps = viewport.lens() == RadialLens{} ? 1 : 256;
  constexpr std::array<Vec2, 4> plane{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::vector<DVec3> directions;
  for (std::size_t edge = 0; edge < plane.size(); ++edge) {
    for (int i = 0; i < steps; ++i) {
      const Vec2 along = glm::mix(plane[edge], plane[(edge + 1) % plane.size()],
                                  static_cast<float>(i) / static_cast<float>(steps));
      directions.push_back(glm::normalize(DVec3(viewport.direction(along))));
    }
  }
  return directions;
}

}  // namespace

Vec2 ImageRectangle::place(const Vec2& point) const {
  const double u = u_begin + width * static_cast<double>(point.x);
  const double v = v_begin + (v_end - v_begin) * static_cast<double>(point.y);
  // Rounding to float can reach 1, which is the seam's other side.
  const auto wrapped = static_cast<float>(u - std::floor(u));
  return {wrapped < 1.0F ? wrapped : 0.0F, static_cast<float>(v)};
}

bool ImageRectangle::contains(const Vec2& image) const {
  const double along = image.x - u_begin;
  return along - std::floor(along) <= width && image.y >= v_begin && image.y <= v_end;
}

ImageRectangle bounding_rectangle(const Viewport& viewport) {
  const std::vector<DVec3> corners = outline(viewport);
  double low_rad = pi / 2.0;
  double high_rad = -pi / 2.0;
  // Azimuths relative to the first corner. Along an edge they change by less than half a turn.
  double azimuth_rad = 0.0;
  double left_rad = 0.0;
  double right_rad = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const DVec3& a = corners[i];
    const DVec3& b = corners[(i + 1) % corners.size()];
    add_arc(a, b, low_rad, high_rad);
    azimuth_rad += std::atan2(b.x * -a.z + b.z * a.x, a.x * b.x + a.z * b.z);
    left_rad = std::min(left_rad, azimuth_rad);
    right_rad = std::max(right_rad, azimuth_rad);
  }
  ImageRectangle rectangle{.v_begin = 0.5 - high_rad / pi, .v_end = 0.5 - low_rad / pi};
  const bool goes_around_a_pole = std::abs(azimuth_rad) > pi;
  if (goes_around_a_pole) {
    const Vec3 middle = viewport.direction({0.5F, 0.5F});
    (middle.y > 0.0F ? rectangle.v_begin : rectangle.v_end) = middle.y > 0.0F ? 0.0 : 1.0;
    return rectangle;
  }
  const double first = std::atan2(corners[0].x, -corners[0].z);
  const double u = 0.5 + (first + left_rad) / (2.0 * pi);
  rectangle.u_begin = u - std::floor(u);
  rectangle.width = (right_rad - left_rad) / (2.0 * pi);
  return rectangle;
}

}  // namespace foveola
