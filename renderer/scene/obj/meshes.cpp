#include "renderer/scene/obj/meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "renderer/base/transformed.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/scene/obj/polygon.h"
#include "renderer/scene/prepare/mesh_edit.h"

namespace foveola {
namespace {

struct CornerHash {
  std::size_t operator()(const ObjCorner& corner) const {
    std::uint64_t hash = 0;
    for (const int value : {corner.position, corner.uv, corner.normal}) {
      // The multiplier of Knuth's 64-bit linear congruential generator.
      hash = (hash ^ static_cast<std::uint32_t>(value)) * 6364136223846793005ULL;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

class MeshBuilder {
 public:
  MeshBuilder(const ObjFile& obj, const ObjPart& part, bool is_textured)
      : obj_(obj),
        has_normals_(std::ranges::any_of(
            part.corners, [](const ObjCorner& corner) { return corner.normal >= 0; })),
        has_uvs_(is_textured && std::ranges::any_of(part.corners, [](const ObjCorner& corner) {
                   return corner.uv >= 0;
                 })) {
    mesh_.name = part.object;
    if (has_uvs_) {
      mesh_.uv_sets.resize(1);
    }
  }

  void add_face(std::span<const ObjCorner> corners) {
    std::vector<Vec3> positions =
        transformed(corners, [&](const ObjCorner& corner) { return position_of(corner); });
    const bool is_flat =
        has_normals_ && std::ranges::any_of(corners, [](const auto& c) { return c.normal < 0; });
    const int plane = is_flat ? add_plane(positions) : -1;
    for (const auto& triangle : triangulate(positions)) {
      std::array<std::uint32_t, 3> vertices{};
      for (std::size_t i = 0; i < 3; ++i) {
        vertices[i] = vertex_of(corners[triangle[i]], plane);
      }
      mesh_.triangles.push_back(vertices);
    }
  }

  Mesh take() && { return std::move(mesh_); }

 private:
  const Vec3& position_of(const ObjCorner& corner) const {
    return obj_.positions[static_cast<std::size_t>(corner.position)];
  }

  /// A number for a face's own normal, beyond those of the file.
  int add_plane(std::span<const Vec3> positions) {
    plane_normal_ = Vec3(glm::normalize(area_vector(positions)));
    return first_plane_ + planes_++;
  }

  std::uint32_t vertex_of(const ObjCorner& corner, int plane) {
    ObjCorner key = corner;
    key.uv = has_uvs_ ? corner.uv : -1;
    key.normal = has_normals_ && plane < 0 ? corner.normal : plane;
    const auto [known, is_new] =
        vertices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) {
      mesh_.positions.push_back(position_of(corner));
      if (has_normals_) {
        mesh_.normals.push_back(plane < 0 ? obj_.normals[static_cast<std::size_t>(key.normal)]
                                          : plane_normal_);
      }
      if (has_uvs_) {
        mesh_.uv_sets[0].push_back(uv_of(corner));
      }
      if (!obj_.colors.empty()) {
        mesh_.colors.emplace_back(obj_.colors[static_cast<std::size_t>(corner.position)], 1.0F);
      }
    }
    return known->second;
  }

  /// Texture coordinates with v downwards.
  Vec2 uv_of(const ObjCorner& corner) const {
    if (corner.uv < 0) {
      return Vec2(0.0F);
    }
    const Vec2 uv = obj_.uvs[static_cast<std::size_t>(corner.uv)];
    return {uv.x, 1.0F - uv.y};
  }

  const ObjFile& obj_;
  bool has_normals_;
  bool has_uvs_;
  int first_plane_ = static_cast<int>(obj_.normals.size());
  int planes_ = 0;
  Vec3 plane_normal_{0.0F};  ///< normal of the last face
  Mesh mesh_;
  std::unordered_map<ObjCorner, std::uint32_t, CornerHash> vertices_;
};

}  // namespace

Mesh mesh_of(const ObjFile& obj, const ObjPart& part, bool is_textured, Warnings& warnings) {
  MeshBuilder builder(obj, part, is_textured);
  const std::span<const ObjCorner> corners(part.corners);
  for (std::size_t i = 0; i < part.begins.size(); ++i) {
    throw_if_work_stopped();
    const std::size_t end = i + 1 < part.begins.size() ? part.begins[i + 1] : corners.size();
    builder.add_face(corners.subspan(part.begins[i], end - part.begins[i]));
  }
  Mesh mesh = std::move(builder).take();
  warnings.add("triangles without area or with coordinates that are not finite are dropped",
               part.object, drop_degenerate_triangles(mesh));
  warnings.add("invalid normals are replaced by the surface's", part.object, repair_normals(mesh));
  warnings.add("texture coordinates that are not finite are replaced by 0", part.object,
               repair_uvs(mesh));
  warnings.add("vertex colours are clamped to their range", part.object, repair_colors(mesh));
  drop_white_colors(mesh);
  if (is_textured && mesh.uv_sets.empty() && !mesh.triangles.empty()) {
    warnings.add("texture coordinates are missing: a textured material shows no texture",
                 part.object);
  }
  return mesh;
}

}  // namespace foveola
