// Small scenes that the tests build in code.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "renderer/scene/scene.h"

namespace foveola {

/// The parallelogram corner, corner + a, corner + a + b, corner + b; its front faces a x b.
inline Mesh quad(const Vec3& corner, const Vec3& a, const Vec3& b, int material) {
  Mesh mesh;
  mesh.material = material;
  mesh.positions = {corner, corner + a, corner + a + b, corner + b};
  mesh.uv_sets = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The axis-aligned box of half side `half` around `center`, its fronts inside.
inline Mesh inward_box(const Vec3& center, float half, int material) {
  Mesh mesh;
  mesh.material = material;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const Vec3 sign(i & 1U ? 1 : -1, i & 2U ? 1 : -1, i & 4U ? 1 : -1);
    mesh.positions.push_back(center + half * sign);
  }
  const std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}}};
  for (const auto& f : faces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  for (auto& t : mesh.triangles) {
    const Vec3 normal = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                   mesh.positions[t[2]] - mesh.positions[t[0]]);
    if (glm::dot(normal, mesh.positions[t[0]] - center) > 0.0F) {
      std::swap(t[1], t[2]);
    }
  }
  return mesh;
}

/// A sphere of 20 * 4^level triangles around the origin, its fronts inside, smoothly shaded.
inline Mesh inward_sphere(float radius, int level, int material) {
  const float g = 0.5F * (1.0F + std::sqrt(5.0F));
  Mesh mesh;
  mesh.material = material;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 5, 11}, {0, 1, 5},  {0, 7, 1},   {0, 10, 7}, {0, 11, 10},
                    {1, 9, 5},  {5, 4, 11}, {11, 2, 10}, {10, 6, 7}, {7, 8, 1},
                    {3, 4, 9},  {3, 2, 4},  {3, 6, 2},   {3, 8, 6},  {3, 9, 8},
                    {4, 5, 9},  {2, 11, 4}, {6, 10, 2},  {8, 7, 6},  {9, 1, 8}};
  for (int i = 0; i < level; ++i) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] = midpoints.try_emplace(
          std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) {
        mesh.positions.push_back(glm::normalize(mesh.positions[a]) +
                                 glm::normalize(mesh.positions[b]));
      }
      return found->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = midpoint(a, b);
      const std::uint32_t bc = midpoint(b, c);
      const std::uint32_t ca = midpoint(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& position : mesh.positions) {
    mesh.normals.push_back(-glm::normalize(position));
    position = radius * glm::normalize(position);
  }
  return mesh;
}

inline Material dielectric(float albedo, float roughness = 1.0F) {
  Material material;
  material.base_color = Rgb(albedo);
  material.roughness = roughness;
  return material;
}

inline Material metal(float albedo, float roughness) {
  Material material = dielectric(albedo, roughness);
  material.metallic = 1.0F;
  return material;
}

/// Black but for its coat, and shining.
inline Material emitter(float radiance, bool double_sided = false) {
  Material material = dielectric(0.0F);
  material.emission = Rgb(radiance);
  material.double_sided = double_sided;
  return material;
}

inline Environment constant_environment(float radiance) {
  Environment environment;
  environment.radiance = Rgb(radiance);
  return environment;
}

}  // namespace foveola
