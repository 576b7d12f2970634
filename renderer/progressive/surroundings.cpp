#include "renderer/progressive/surroundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/trace/triangle.h"

namespace foveola {

Vec3 fibonacci_direction(int index, int count) {
  const double y = 1.0 - (2.0 * index + 1.0) / count;
  const double azimuth_rad = 2.0 * std::numbers::pi * index / std::numbers::phi;
  const double radius = std::sqrt(1.0 - y * y);
  return {radius * std::cos(azimuth_rad), y, radius * std::sin(azimuth_rad)};
}

bool is_front(const Scene& scene, const Hit& hit, const Vec3& direction) {
  return glm::dot(Triangle(scene, hit.object, hit.triangle).front_normal(), direction) < 0.0F;
}

Surroundings look_around(const Scene& scene, const RayScene& rays, const Vec3& from, int rays_count,
                         double furthest_m) {
  int hits = 0;
  int fronts = 0;
  double log_distances = 0.0;
  for (int i = 0; i < rays_count; ++i) {
    const Vec3 direction = fibonacci_direction(i, rays_count);
    const Hit hit = rays.closest_hit(from, direction);
    if (!hit.missed()) {
      ++hits;
      fronts += is_front(scene, hit, direction) ? 1 : 0;
    }
    const double nearest_m = 1e-6 * furthest_m;  // at which logarithms end
    log_distances += std::log(std::clamp<double>(hit.t, nearest_m, furthest_m));
  }
  return {.share_hit = static_cast<double>(hits) / rays_count,
          .share_fronts = hits > 0 ? static_cast<double>(fronts) / hits : 0.0,
          .space_m = std::exp(log_distances / rays_count)};
}

double share_of_fronts_from_outside(const Scene& scene, const RayScene& rays, const Vec3& target,
                                    double distance_m) {
  constexpr int directions = 64;
  int hits = 0;
  int fronts = 0;
  for (int i = 0; i < directions; ++i) {
    const Vec3 outwards = fibonacci_direction(i, directions);
    const Ray ray{.origin = target + static_cast<float>(distance_m) * outwards,
                  .direction = -outwards,
                  .t_max = static_cast<float>(distance_m)};
    const Hit hit = rays.closest_hit(ray);
    if (!hit.missed()) {
      ++hits;
      fronts += is_front(scene, hit, ray.direction) ? 1 : 0;
    }
  }
  return hits > 0 ? static_cast<double>(fronts) / hits : 1.0;
}

std::vector<SightLine> sight_lines(const RayScene& rays, const Vec3& from, const Viewport& viewport,
                                   const IVec2& cells) {
  std::vector<SightLine> lines;
  lines.reserve(static_cast<std::size_t>(cells.x) * cells.y);
  for (int y = 0; y < cells.y; ++y) {
    for (int x = 0; x < cells.x; ++x) {
      const Vec3 direction = viewport.direction((Vec2(x, y) + 0.5F) / Vec2(cells));
      lines.push_back({.direction = direction, .hit = rays.closest_hit(from, direction)});
    }
  }
  return lines;
}

bool is_enclosed(const RayScene& rays, const Vec3& from) {
  constexpr int directions = 256;
  int i = 0;
  while (i < directions && !rays.closest_hit(from, fibonacci_direction(i, directions)).missed()) {
    ++i;
  }
  return i == directions;
}

bool is_light_in_sight(const Scene& scene, const RayScene& rays, const Vec3& from) {
  return std::any_of(scene.lights.begin(), scene.lights.end(), [&](const PunctualLight& light) {
    return light.kind != PunctualLight::Kind::directional &&
           rays.closest_hit(Ray{.origin = from, .direction = light.position - from, .t_max = 1.0F})
               .missed();
  });
}

}  // namespace foveola
