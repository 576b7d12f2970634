#include "renderer/progressive/standpoint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/trace/triangle.h"

namespace foveola {
namespace {

/// Point `index` of `count` spherical Fibonacci points, which lie evenly on the unit sphere
/// (Marques et al., Spherical Fibonacci Point Sets for Illumination Integrals, 2013).
Vec3 fibonacci_direction(int index, int count) {
  const double y = 1.0 - (2.0 * index + 1.0) / count;
  const double azimuth_rad = 2.0 * std::numbers::pi * index / std::numbers::phi;
  const double radius = std::sqrt(1.0 - y * y);
  return {radius * std::cos(azimuth_rad), y, radius * std::sin(azimuth_rad)};
}

bool is_light_in_sight(const Scene& scene, const RayScene& rays, const Vec3& from) {
  return std::any_of(scene.lights.begin(), scene.lights.end(), [&](const PunctualLight& light) {
    return light.kind != PunctualLight::Kind::directional &&
           rays.closest_hit(Ray{.origin = from, .direction = light.position - from, .t_max = 1.0F})
               .missed();
  });
}

bool is_inside_closed_object(const Scene& scene, const RayScene& rays, const Vec3& from) {
  constexpr int directions = 256;
  constexpr double nearly_all = 0.8;
  int hits = 0;
  int backs = 0;
  for (int i = 0; i < directions; ++i) {
    const Vec3 direction = fibonacci_direction(i, directions);
    const Hit hit = rays.closest_hit(from, direction);
    if (!hit.missed()) {
      const Vec3 normal = Triangle(scene, hit.object, hit.triangle).front_normal();
      ++hits;
      backs += glm::dot(normal, direction) > 0.0F ? 1 : 0;
    }
  }
  return hits >= nearly_all * directions && backs >= nearly_all * hits &&
         !is_light_in_sight(scene, rays, from);
}

/// Extents of the bounds along the axes, as parts of the largest.
struct Shape {
  Vec3 extents;
  int thinnest_axis;

  explicit Shape(const Bounds& bounds)
      : extents((bounds.upper - bounds.lower) / max_component(bounds.upper - bounds.lower)),
        thinnest_axis(static_cast<int>(std::min_element(&extents.x, &extents.x + 3) - &extents.x)) {
  }

  bool is_flat() const { return extents[thinnest_axis] < 1e-3F; }

  /// The direction from the middle to where all of it is seen, and no slab or sheet edge-on.
  Vec3 front() const {
    constexpr float slab = 0.05F;
    Vec3 direction(0.0F, 0.0F, 1.0F);
    if (extents[thinnest_axis] < slab) {
      direction[thinnest_axis] = 1.0F;
    }
    return glm::normalize(direction);
  }
};

Standpoint in_front_of(const Bounds& bounds, const Vec3& front, std::string reason) {
  const DVec3 lower(bounds.lower);
  const DVec3 upper(bounds.upper);
  const double distance = 0.5 * glm::distance(lower, upper) / std::sin(radians(30.0));
  return {.position = Vec3(0.5 * (lower + upper) + distance * DVec3(front)),
          .heading = azimuth_elevation(Vec3(0.0F) - front),
          .reason = std::move(reason)};
}

}  // namespace

Standpoint choose_standpoint(const Scene& scene, const RayScene& rays) {
  const Bounds bounds = scene.bounds();
  const Vec3 middle = 0.5F * bounds.lower + 0.5F * bounds.upper;
  constexpr float largest = 1e18F;  // beyond it Embree meets nothing
  if (bounds.lower != bounds.upper && max_component(bounds.upper - bounds.lower) < largest) {
    const Shape shape(bounds);
    if (shape.is_flat()) {
      return in_front_of(bounds, shape.front(), "in front of all there is, since it is flat");
    }
    if (is_inside_closed_object(scene, rays, middle)) {
      return in_front_of(bounds, shape.front(),
                         "in front of all there is, since the middle of its bounds lies inside a "
                         "closed object");
    }
  }
  return {.position = middle, .heading = {}, .reason = "the middle of its bounds"};
}

}  // namespace foveola
