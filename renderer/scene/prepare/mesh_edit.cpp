#include "renderer/scene/prepare/mesh_edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace foveola {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The transform of normals: the transposed inverse, up to a positive factor. As a matrix of
/// cofactors it also exists for transforms that flatten space.
DMat3 normal_transform(const DMat3& linear) {
  const DMat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                        glm::cross(linear[0], linear[1]));
  return glm::determinant(linear) < 0.0 ? -cofactors : cofactors;
}

/// Twice the area, along the normal of the front face.
DVec3 area_vector_of(const Mesh& mesh, const Triangle& triangle) {
  const DVec3 a(mesh.positions[triangle[0]]);
  return glm::cross(DVec3(mesh.positions[triangle[1]]) - a, DVec3(mesh.positions[triangle[2]]) - a);
}

/// False also for a non-finite triangle: every comparison with NaN fails, and an infinite corner
/// makes the length infinite or NaN.
bool has_area(const Mesh& mesh, const Triangle& triangle) {
  const double length = glm::length(area_vector_of(mesh, triangle));
  return length > 0.0 && std::isfinite(length);
}

void drop_unused_vertices(Mesh& mesh) {
  constexpr std::uint32_t unused = 0xFFFFFFFF;
  std::vector<std::uint32_t> renumbered(mesh.positions.size(), unused);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      renumbered[vertex] = 0;
    }
  }
  std::uint32_t kept = 0;
  for (std::uint32_t& number : renumbered) {
    number = number == unused ? unused : kept++;
  }
  for_each_vertex_list(mesh, [&](auto& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (renumbered[i] != unused) {
        list[renumbered[i]] = list[i];
      }
    }
    list.resize(kept);
    list.shrink_to_fit();
  });
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& vertex : triangle) {
      vertex = renumbered[vertex];
    }
  }
}

}  // namespace

void transform(Mesh& mesh, const DMat4& to_from) {
  const DMat3 linear(to_from);
  const DVec3 translation(to_from[3]);
  for (Vec3& position : mesh.positions) {
    position = Vec3(linear * DVec3(position) + translation);
  }
  const DMat3 turn = normal_transform(linear);
  for (Vec3& normal : mesh.normals) {
    normal = Vec3(glm::normalize(turn * DVec3(normal)));
  }
  const bool mirrors = glm::determinant(linear) < 0.0;
  for (Vec4& tangent : mesh.tangents) {
    // The bitangent is a direction of the surface like the tangent; the cross product of normal and
    // tangent is reversed by mirroring.
    tangent = Vec4(Vec3(glm::normalize(linear * DVec3(tangent))), mirrors ? -tangent.w : tangent.w);
  }
  if (mirrors) {
    for (Triangle& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
}

std::size_t drop_degenerate_triangles(Mesh& mesh) {
  const std::size_t dropped = std::erase_if(
      mesh.triangles, [&](const Triangle& triangle) { return !has_area(mesh, triangle); });
  if (dropped > 0) {
    drop_unused_vertices(mesh);
  }
  return dropped;
}

std::size_t repair_normals(Mesh& mesh) {
  std::vector<std::size_t> broken;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const double length = glm::length(DVec3(mesh.normals[i]));
    if (length > 0.0 && std::isfinite(length)) {
      mesh.normals[i] = Vec3(DVec3(mesh.normals[i]) / length);
    } else {
      broken.push_back(i);
    }
  }
  if (broken.empty()) {
    return 0;
  }
  std::vector<DVec3> around(mesh.positions.size(), DVec3(0.0));
  for (const Triangle& triangle : mesh.triangles) {
    const DVec3 area = area_vector_of(mesh, triangle);
    for (const std::uint32_t vertex : triangle) {
      around[vertex] += area;
    }
  }
  for (const std::size_t i : broken) {
    const double length = glm::length(around[i]);
    mesh.normals[i] = length > 0.0 ? Vec3(around[i] / length) : Vec3(0.0F, 1.0F, 0.0F);
  }
  return broken.size();
}

std::size_t repair_uvs(Mesh& mesh) {
  std::size_t repaired = 0;
  for (std::vector<Vec2>& uvs : mesh.uv_sets) {
    for (Vec2& uv : uvs) {
      if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
        uv = Vec2(0.0F);
        ++repaired;
      }
    }
  }
  return repaired;
}

std::size_t repair_colors(Mesh& mesh) {
  std::size_t repaired = 0;
  for (Vec4& color : mesh.colors) {
    Vec4 mended;
    for (int i = 0; i < 4; ++i) {
      mended[i] = std::isnan(color[i]) ? 1.0F : std::clamp(color[i], 0.0F, 1.0F);
    }
    repaired += mended == color ? 0U : 1U;
    color = mended;
  }
  return repaired;
}

void drop_white_colors(Mesh& mesh) {
  const auto is_white = [](const Vec4& color) { return color == Vec4(1.0F); };
  if (std::ranges::all_of(mesh.colors, is_white)) {
    mesh.colors = {};
  }
}

}  // namespace foveola
