// What a mesh's vertices and its material's textures say about one of its points.
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

/// The value at `barycentric` of an attribute that is given at the corners, or lanes of them.
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

/// Fetches into the cache where a triangle's vertices are.
inline void prefetch_triangle(const Mesh& mesh, std::uint32_t triangle) {
  __builtin_prefetch(&mesh.triangles[triangle]);
}

/// Fetches what the mesh says of them.
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
  /// How wide the ray is here, as a share of the triangle's size: the square root of the ratio of
  /// the areas. 0 reads textures at their finest.
  float relative_width = 0.0F;
};

/// White where the mesh has none.
inline Vec4 vertex_color(const MeshPoint& point) {
  return point.mesh.colors.empty()
             ? Vec4(1.0F)
             : interpolate(point.mesh.colors, point.mesh.triangles[point.triangle],
                           point.barycentric);
}

/// What of a texture a point reads.
struct TextureFootprint {
  const Texture& texture;
  Vec2 uv;
  float uv_width;  ///< 0: the finest level

  Vec4 value() const { return texture.sample(uv, uv_width); }
  void prefetch() const { texture.prefetch(uv, uv_width); }
};

/// The widest footprint, as a share of its triangle's size. What it takes in of the texture beyond
/// the triangle, by bilinear filtering of texels of its width, is then less than a hundredth.
inline constexpr float max_footprint_share = 1.0F / 16.0F;

/// There must be a texture, and the mesh must have coordinates.
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

/// White where the value has no texture or the mesh no coordinates for it.
inline Vec4 texture_value(const Scene& scene, const TextureUse& use, const MeshPoint& point) {
  return use.exists() && !point.mesh.uv_sets.empty() ? texture_footprint(scene, use, point).value()
                                                     : Vec4(1.0F);
}

/// Fetches into the cache the texels of the textures that most surfaces have.
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
