// A mesh's vertex attributes and texture values at a point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

inline const Material& material_of(const Scene& scene, const Mesh& mesh) {
  return scene.materials[static_cast<std::size_t>(mesh.material)];
}

/// The value at `barycentric` of an attribute given at the corners, or lanes of them.
template <typename Value, typename Barycentric>
inline Value interpolate(const Value& p0, const Value& p1, const Value& p2,
                         const Barycentric& barycentric) {
  return (1.0F - barycentric.x - barycentric.y) * p0 + barycentric.x * p1 + barycentric.y * p2;
}
template <typename Value>
inline Value interpolate(const std::vector<Value>& attribute,
                         const std::array<std::uint32_t, 3>& triangle, const Vec2& barycentric) {
  return interpolate(attribute[triangle[0]], attribute[triangle[1]], attribute[triangle[2]],
                     barycentric);
}

/// Prefetches a triangle's vertex indices.
inline void prefetch_triangle(const Mesh& mesh, std::uint32_t triangle) {
  __builtin_prefetch(&mesh.triangles[triangle]);
}

/// Prefetches the vertices' attributes.
inline void prefetch_vertices(const Mesh& mesh, std::uint32_t triangle) {
  for (const std::uint32_t vertex : mesh.triangles[triangle]) {
    const auto prefetch = [vertex](const auto& attribute) {
      if (!attribute.empty()) {
        __builtin_prefetch(&attribute[vertex]);
      }
    };
    prefetch(mesh.positions);
    prefetch(mesh.normals);
    prefetch(mesh.tangents);
    std::ranges::for_each(mesh.uv_sets, prefetch);
  }
}

struct MeshPoint {
  const Mesh& mesh;
  std::uint32_t triangle = 0;
  Vec2 barycentric{0.0F};
  /// The ray's width relative to the triangle: the square root of the ratio of areas. 0 reads
  /// textures at their finest level.
  float relative_width = 0.0F;
};

/// White if the mesh has no colours.
inline Vec4 vertex_color(const MeshPoint& point) {
  return point.mesh.colors.empty()
             ? Vec4(1.0F)
             : interpolate(point.mesh.colors, point.mesh.triangles[point.triangle],
                           point.barycentric);
}

/// The part of a texture that a point reads.
struct TextureFootprint {
  const Texture& texture;
  Vec2 uv;
  float uv_width;  ///< 0: the finest level

  Vec4 value() const { return texture.sample(uv, uv_width); }
  void prefetch() const { texture.prefetch(uv, uv_width); }
};

/// Maximum footprint, relative to its triangle. Bilinear filtering beyond the triangle then adds
/// less than a hundredth.
inline constexpr float max_footprint_share = 1.0F / 16.0F;

/// Requires a texture, and texture coordinates of the mesh.
inline TextureFootprint texture_footprint(const Scene& scene, const TextureUse& use,
                                          const MeshPoint& point) {
  const std::vector<Vec2>& uvs = point.mesh.uv_sets[static_cast<std::size_t>(use.uv_set)];
  const auto& triangle = point.mesh.triangles[point.triangle];
  const Vec2 uv = use.texture_from_mesh * Vec3(interpolate(uvs, triangle, point.barycentric), 1.0F);
  const Texture& texture = scene.textures[static_cast<std::size_t>(use.texture)];
  if (!(point.relative_width > 0.0F)) {
    return {.texture = texture, .uv = uv, .uv_width = 0.0F};
  }
  const Vec2 side1 = use.texture_from_mesh * Vec3(uvs[triangle[1]] - uvs[triangle[0]], 0.0F);
  const Vec2 side2 = use.texture_from_mesh * Vec3(uvs[triangle[2]] - uvs[triangle[0]], 0.0F);
  const float uv_area = std::abs(side1.x * side2.y - side1.y * side2.x);
  const float share = std::min(point.relative_width, max_footprint_share);
  return {.texture = texture, .uv = uv, .uv_width = share * std::sqrt(uv_area)};
}

/// White without a texture, or without texture coordinates.
inline Vec4 texture_value(const Scene& scene, const TextureUse& use, const MeshPoint& point) {
  return use.exists() && !point.mesh.uv_sets.empty() ? texture_footprint(scene, use, point).value()
                                                     : Vec4(1.0F);
}

/// Prefetches the texels of the most common textures.
inline void prefetch_textures(const Scene& scene, const MeshPoint& point) {
  if (point.mesh.uv_sets.empty()) {
    return;
  }
  const Material& material = material_of(scene, point.mesh);
  for (const TextureUse* use : {&material.base_color_texture, &material.metallic_roughness_texture,
                                &material.normal_texture}) {
    if (use->exists()) {
      texture_footprint(scene, *use, point).prefetch();
    }
  }
}

}  // namespace foveola
