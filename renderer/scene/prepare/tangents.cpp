#include "renderer/scene/prepare/tangents.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/scene/prepare/mesh_edit.h"

namespace foveola {
namespace {

using DVec2 = glm::dvec2;
using Triangle = std::array<std::uint32_t, 3>;

/// A texture's mapping on a triangle.
struct Layout {
  DVec3 direction;  ///< the texture's horizontal axis, not of unit length
  bool mirrored;
};

constexpr float sign_of(bool mirrored) { return mirrored ? -1.0F : 1.0F; }

/// The part of `direction` in the plane of the unit vector `normal`, with unit length; nullopt if
/// it is too short.
std::optional<DVec3> in_plane(const DVec3& direction, const DVec3& normal) {
  const double length = glm::length(direction);
  const DVec3 flat = direction - glm::dot(direction, normal) * normal;
  const double flat_length = glm::length(flat);
  if (!(flat_length > 1e-6 * length) || !std::isfinite(flat_length)) {
    return std::nullopt;
  }
  return flat / flat_length;
}

std::optional<Layout> layout_of(const Mesh& mesh, const Triangle& triangle, int uv_set,
                                const Mat3x2& texture_from_mesh) {
  std::array<DVec3, 3> corners{};
  std::array<DVec2, 3> uvs{};
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = DVec3(mesh.positions[triangle[i]]);
    const Vec2 uv = mesh.uv_sets[static_cast<std::size_t>(uv_set)][triangle[i]];
    uvs[i] = glm::dmat3x2(texture_from_mesh) * DVec3(uv.x, uv.y, 1.0);
  }
  const DVec2 first = uvs[1] - uvs[0];
  const DVec2 second = uvs[2] - uvs[0];
  const double area = first.x * second.y - first.y * second.x;
  if (area == 0.0 || !std::isfinite(area)) {
    return std::nullopt;
  }
  const DVec3 along_u = second.y * (corners[1] - corners[0]) - first.y * (corners[2] - corners[0]);
  // v points down in the texture: an unmirrored one has corners that turn clockwise in (u, v) where
  // they turn counter-clockwise on the surface.
  const bool mirrored = area > 0.0;
  return Layout{.direction = mirrored ? along_u : -along_u, .mirrored = mirrored};
}

void unshare_vertices(Mesh& mesh) {
  const std::vector<Triangle> triangles = mesh.triangles;
  for_each_vertex_list(mesh, [&](auto& list) {
    const auto shared = list;
    list.clear();
    list.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles) {
      for (const std::uint32_t vertex : triangle) {
        list.push_back(shared[vertex]);
      }
    }
  });
  std::uint32_t next = 0;
  for (Triangle& triangle : mesh.triangles) {
    triangle = {next, next + 1, next + 2};
    next += 3;
  }
}

std::vector<Vec3> flat_normals(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size());
  for (const Triangle& triangle : mesh.triangles) {
    const DVec3 a(mesh.positions[triangle[0]]);
    const DVec3 area =
        glm::cross(DVec3(mesh.positions[triangle[1]]) - a, DVec3(mesh.positions[triangle[2]]) - a);
    for (const std::uint32_t vertex : triangle) {
      normals[vertex] = Vec3(glm::normalize(area));
    }
  }
  return normals;
}

/// For each vertex, the number of the first with the same position, normal and texture coordinates.
std::vector<std::uint32_t> welded(const Mesh& mesh, int uv_set) {
  using Key = std::array<std::uint32_t, 8>;
  const std::vector<Vec2>& uvs = mesh.uv_sets[static_cast<std::size_t>(uv_set)];
  std::vector<std::pair<Key, std::uint32_t>> vertices(mesh.positions.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const Vec3& p = mesh.positions[i];
    const Vec3& n = mesh.normals[i];
    const std::array<float, 8> values = {p.x, p.y, p.z, n.x, n.y, n.z, uvs[i].x, uvs[i].y};
    vertices[i] = {std::bit_cast<Key>(values), i};
  }
  std::ranges::sort(vertices);
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const bool is_first = i == 0 || vertices[i].first != vertices[i - 1].first;
    const std::uint32_t number = vertices[i].second;
    first[number] = is_first ? number : first[vertices[i - 1].second];
  }
  return first;
}

/// The angle at corner `i` of `triangle`, between its edges projected into the plane of `normal`.
double corner_angle(const Mesh& mesh, const Triangle& triangle, std::size_t i,
                    const DVec3& normal) {
  const DVec3 corner(mesh.positions[triangle[i]]);
  const auto a = in_plane(DVec3(mesh.positions[triangle[(i + 1) % 3]]) - corner, normal);
  const auto b = in_plane(DVec3(mesh.positions[triangle[(i + 2) % 3]]) - corner, normal);
  return a && b ? 2.0 * std::atan2(glm::length(*a - *b), glm::length(*a + *b)) : 0.0;
}

/// Sums of directions around a vertex, for triangles with an unmirrored texture [0] and a mirrored
/// one [1].
using Around = std::array<DVec3, 2>;

/// Appends a copy of each vertex shared by both kinds of triangles, for the mirrored ones. Returns
/// the mirrored vertices, and each copy's original.
void double_shared_vertices(Mesh& mesh, const std::vector<std::optional<Layout>>& layouts,
                            std::vector<bool>& mirrored, std::vector<std::uint32_t>& original) {
  const std::size_t count = mesh.positions.size();
  std::vector<std::array<bool, 2>> used(count, {false, false});
  for (std::size_t t = 0; t < layouts.size(); ++t) {
    for (const std::uint32_t vertex : mesh.triangles[t]) {
      if (layouts[t]) {
        used[vertex][layouts[t]->mirrored ? 1 : 0] = true;
      }
    }
  }
  mirrored.resize(count);
  original.resize(count);
  std::iota(original.begin(), original.end(), 0U);
  std::vector<std::uint32_t> copy_of(count);
  for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
    const bool both = used[vertex][0] && used[vertex][1];
    mirrored[vertex] = used[vertex][1] && !both;
    if (both) {
      copy_of[vertex] = static_cast<std::uint32_t>(original.size());
      original.push_back(vertex);
      mirrored.push_back(true);
      for_each_vertex_list(mesh, [&](auto& list) {
        const auto value = list[vertex];
        list.push_back(value);
      });
    }
  }
  for (std::size_t t = 0; t < layouts.size(); ++t) {
    for (std::uint32_t& vertex : mesh.triangles[t]) {
      if (layouts[t] && layouts[t]->mirrored && !mirrored[vertex]) {
        vertex = copy_of[vertex];
      }
    }
  }
}

}  // namespace

void add_tangents(Mesh& mesh, int uv_set, const Mat3x2& texture_from_mesh) {
  mesh.tangents.clear();
  const bool is_flat = mesh.normals.empty();
  if (is_flat) {
    unshare_vertices(mesh);
    mesh.normals = flat_normals(mesh);
  }
  const std::vector<std::uint32_t> first = welded(mesh, uv_set);
  std::vector<Around> around(mesh.positions.size(), {DVec3(0.0), DVec3(0.0)});
  std::vector<std::optional<Layout>> layouts;
  layouts.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    throw_if_work_stopped();
    const auto layout = layouts.emplace_back(layout_of(mesh, triangle, uv_set, texture_from_mesh));
    for (std::size_t i = 0; i < 3 && layout; ++i) {
      const DVec3 normal(mesh.normals[triangle[i]]);
      if (const auto direction = in_plane(layout->direction, normal)) {
        around[first[triangle[i]]][layout->mirrored ? 1 : 0] +=
            corner_angle(mesh, triangle, i, normal) * *direction;
      }
    }
  }
  std::vector<bool> mirrored;
  std::vector<std::uint32_t> original;
  double_shared_vertices(mesh, layouts, mirrored, original);
  mesh.tangents.resize(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
    const DVec3& sum = around[first[original[i]]][mirrored[i] ? 1 : 0];
    const auto direction = in_plane(sum, DVec3(mesh.normals[i]));
    mesh.tangents[i] =
        Vec4(direction ? Vec3(*direction) : Frame(mesh.normals[i]).tangent, sign_of(mirrored[i]));
  }
  if (is_flat) {
    mesh.normals.clear();
  }
}

std::size_t straighten_tangents(Mesh& mesh) {
  std::size_t unusable = 0;
  for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
    Vec4& tangent = mesh.tangents[i];
    const auto direction = in_plane(DVec3(tangent), DVec3(mesh.normals[i]));
    if (direction && tangent.w != 0.0F && !std::isnan(tangent.w)) {
      tangent = Vec4(Vec3(*direction), sign_of(tangent.w < 0.0F));
    } else {
      ++unusable;
    }
  }
  return unusable;
}

}  // namespace foveola
