#include "reference_renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace foveola::reference {
namespace {

/// Rays leave a surface this far from it; the worlds are a few units large.
constexpr double smallest_distance = 1e-7;

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  DVec3 front{0.0};  ///< unit normal
  int surface = -1;
};

void meet(const Sphere& sphere, const DVec3& origin, const DVec3& direction, Hit& hit) {
  const DVec3 to = sphere.center - origin;
  const double middle = glm::dot(to, direction);
  const DVec3 aside = to - middle * direction;
  const double squared = sphere.radius * sphere.radius - glm::dot(aside, aside);
  if (squared < 0.0) {
    return;
  }
  const double half_chord = std::sqrt(squared);
  for (const double distance : {middle - half_chord, middle + half_chord}) {
    if (distance > smallest_distance && distance < hit.distance) {
      const DVec3 front = glm::normalize(origin + distance * direction - sphere.center);
      hit = {.distance = distance, .front = front, .surface = sphere.surface};
      return;
    }
  }
}

void meet(const Panel& panel, const DVec3& origin, const DVec3& direction, Hit& hit) {
  const DVec3 normal = glm::cross(panel.a, panel.b);
  const double distance = glm::dot(panel.corner - origin, normal) / glm::dot(direction, normal);
  if (!(distance > smallest_distance && distance < hit.distance)) {
    return;
  }
  const DVec3 on_plane = origin + distance * direction - panel.corner;
  const double squared = glm::dot(normal, normal);
  const double s = glm::dot(glm::cross(on_plane, panel.b), normal) / squared;
  const double t = glm::dot(glm::cross(panel.a, on_plane), normal) / squared;
  const bool is_inside = panel.is_triangle ? s + t <= 1.0 : s <= 1.0 && t <= 1.0;
  if (s >= 0.0 && t >= 0.0 && is_inside) {
    hit = {.distance = distance, .front = normal / std::sqrt(squared), .surface = panel.surface};
  }
}

Hit closest(const World& world, const DVec3& origin, const DVec3& direction) {
  Hit hit;
  for (const Sphere& sphere : world.spheres) {
    meet(sphere, origin, direction, hit);
  }
  for (const Panel& panel : world.panels) {
    meet(panel, origin, direction, hit);
  }
  return hit;
}

/// A direction on the side of `normal` with a density of cosine over pi: a point of the unit sphere
/// around the normal's end.
DVec3 diffuse_direction(const DVec3& normal, Pcg32& random) {
  const double z = 2.0 * random.uniform() - 1.0;
  const double turn = 2.0 * std::numbers::pi * random.uniform();
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return glm::normalize(normal + DVec3(r * std::cos(turn), r * std::sin(turn), z));
}

/// Fresnel's equations for n1 cos1 towards n2 cos2.
double fresnel(double n1, double cos1, double n2, double cos2) {
  const double s = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
  const double p = (n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1);
  return (s * s + p * p) / 2.0;
}

/// Where a path goes on, and by what it is multiplied.
struct Scattered {
  DVec3 direction;
  DVec3 weight;
};

/// front: on the outer side of the glass. Snell's law in vector form.
Scattered pass_glass(const Surface& glass, const DVec3& front, const DVec3& direction,
                     Pcg32& random) {
  const bool enters = glm::dot(front, direction) < 0.0;
  const DVec3 normal = enters ? front : -front;
  const double n1 = enters ? 1.0 : glass.ior;
  const double n2 = enters ? glass.ior : 1.0;
  const double cos1 = -glm::dot(normal, direction);
  const DVec3 mirrored = direction + 2.0 * cos1 * normal;
  const double squared_sine2 = n1 * n1 / (n2 * n2) * (1.0 - cos1 * cos1);
  if (squared_sine2 >= 1.0) {
    return {mirrored, DVec3(1.0)};
  }
  const double cos2 = std::sqrt(1.0 - squared_sine2);
  if (random.uniform() < fresnel(n1, cos1, n2, cos2)) {
    return {mirrored, DVec3(1.0)};
  }
  return {n1 / n2 * direction + (n1 / n2 * cos1 - cos2) * normal, DVec3(n1 * n1 / (n2 * n2))};
}

Scattered scatter(const Surface& surface, const DVec3& front, const DVec3& direction,
                  Pcg32& random) {
  if (surface.kind == Kind::glass) {
    return pass_glass(surface, front, direction, random);
  }
  const DVec3 normal = glm::dot(front, direction) < 0.0 ? front : -front;
  if (surface.kind == Kind::diffuse) {
    return {diffuse_direction(normal, random), surface.color};
  }
  const double cosine = -glm::dot(normal, direction);
  const DVec3 reflected = surface.color + (1.0 - surface.color) * std::pow(1.0 - cosine, 5.0);
  return {direction + 2.0 * cosine * normal, reflected};
}

DVec3 equirect_direction(double u, double v) {
  const double azimuth = (u - 0.5) * 2.0 * std::numbers::pi;
  const double elevation = (0.5 - v) * std::numbers::pi;
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          -std::cos(elevation) * std::cos(azimuth)};
}

}  // namespace

DVec3 radiance(const World& world, DVec3 origin, DVec3 direction, int max_depth, Pcg32& random) {
  DVec3 sum(0.0);
  DVec3 throughput(1.0);
  for (int vertex = 1;; ++vertex) {
    const Hit hit = closest(world, origin, direction);
    if (hit.surface < 0) {
      return sum + throughput * world.environment;
    }
    const Surface& surface = world.surfaces[static_cast<std::size_t>(hit.surface)];
    if (glm::dot(hit.front, direction) < 0.0) {
      sum += throughput * surface.emission;
    }
    if (vertex > max_depth) {
      return sum;
    }
    const Scattered next = scatter(surface, hit.front, direction, random);
    throughput *= next.weight;
    origin += hit.distance * direction;
    direction = glm::normalize(next.direction);
  }
}

std::vector<RadianceEstimate> render(const World& world, const DVec3& viewpoint, int columns,
                                     int batch_samples, int max_depth, const Workers& workers) {
  constexpr std::size_t batches = 32;
  const int rows = columns / 2;
  std::vector<std::vector<DVec3>> means(static_cast<std::size_t>(columns * rows),
                                        std::vector<DVec3>(batches, DVec3(0.0)));
  workers.for_each_block(means.size() * batches, 1, [&](std::size_t index, std::size_t) {
    const std::size_t block = index / batches;
    const int left = static_cast<int>(block) % columns;
    const int top = static_cast<int>(block) / columns;
    Pcg32 random(1, index);
    DVec3& mean = means[block][index % batches];
    for (int i = 0; i < batch_samples; ++i) {
      const double u = (left + random.uniform()) / columns;
      const double v = (top + random.uniform()) / rows;
      mean += radiance(world, viewpoint, equirect_direction(u, v), max_depth, random) /
              static_cast<double>(batch_samples);
    }
  });
  std::vector<RadianceEstimate> blocks;
  for (const std::vector<DVec3>& of_batches : means) {
    blocks.push_back(mean_of_batches(of_batches));
  }
  return blocks;
}

}  // namespace foveola::reference
