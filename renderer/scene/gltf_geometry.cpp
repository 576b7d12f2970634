#include "renderer/scene/gltf_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/gltf_fault.h"

namespace foveola {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The accessor of attribute `name`, or -1.
int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

std::vector<std::uint32_t> vertex_order(const tinygltf::Model& model,
                                        const tinygltf::Primitive& primitive,
                                        std::size_t vertex_count, const std::string& place) {
  if (primitive.indices >= 0) {
    return read_indices(model, primitive.indices, place + ".indices");
  }
  std::vector<std::uint32_t> order(vertex_count);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

/// Groups vertices into triangles as the topologies of the specification, section 3.7.2.1, say.
std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& order, int mode) {
  std::vector<Triangle> triangles;
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    triangles.reserve(order.size() / 3);
    for (std::size_t i = 0; i + 2 < order.size(); i += 3) {
      triangles.push_back({order[i], order[i + 1], order[i + 2]});
    }
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < order.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      triangles.push_back({order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]});
    } else {
      triangles.push_back({order[i + 1], order[i + 2], order[0]});
    }
  }
  return triangles;
}

template <typename T>
void keep_only(std::vector<T>& values, const std::vector<bool>& kept) {
  if (values.empty()) {
    return;
  }
  std::size_t end = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) {
      values[end++] = values[i];
    }
  }
  values.resize(end);
  values.shrink_to_fit();
}

void drop_unused_vertices(Mesh& mesh) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      used[vertex] = true;
    }
  }
  if (std::find(used.begin(), used.end(), false) == used.end()) {
    return;
  }
  std::vector<std::uint32_t> renumbered(used.size(), 0);
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) {
      renumbered[i] = next++;
    }
  }
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& vertex : triangle) {
      vertex = renumbered[vertex];
    }
  }
  keep_only(mesh.positions, used);
  keep_only(mesh.normals, used);
  for (std::vector<Vec2>& uvs : mesh.uv_sets) {
    keep_only(uvs, used);
  }
}

/// Many primitives may share one large accessor: only the run of vertices that these triangles use
/// is read, and they count from its beginning afterwards.
ElementRange rebase_on_used_range(std::vector<Triangle>& triangles, std::size_t vertex_count,
                                  const std::string& place) {
  std::uint32_t lowest = triangles.front()[0];
  std::uint32_t highest = lowest;
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) {
      lowest = std::min(lowest, vertex);
      highest = std::max(highest, vertex);
    }
  }
  if (highest >= vertex_count) {
    throw GltfFault(place + ".indices",
                    fmt::format("names vertex {}, but POSITION has {}", highest, vertex_count));
  }
  for (Triangle& triangle : triangles) {
    for (std::uint32_t& vertex : triangle) {
      vertex -= lowest;
    }
  }
  return {.begin = lowest, .end = std::size_t{highest} + 1};
}

void require_count(const tinygltf::Model& model, int accessor, std::size_t vertex_count,
                   const std::string& place) {
  if (const std::size_t count = element_count(model, accessor); count != vertex_count) {
    throw GltfFault(place, fmt::format("accessors[{}] has {} elements, but POSITION has {}",
                                       accessor, count, vertex_count));
  }
}

/// The transform of normals: the transposed inverse, up to a positive factor. As a matrix of
/// cofactors it also exists where the transform flattens space.
DMat3 normal_transform(const DMat3& linear) {
  const DMat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                        glm::cross(linear[0], linear[1]));
  return glm::determinant(linear) < 0.0 ? -cofactors : cofactors;
}

/// Twice the area, along the normal of the front face.
DVec3 area_vector(const Mesh& mesh, const Triangle& triangle) {
  const DVec3 a(mesh.positions[triangle[0]]);
  return glm::cross(DVec3(mesh.positions[triangle[1]]) - a, DVec3(mesh.positions[triangle[2]]) - a);
}

/// False as well for a triangle that is not finite: every comparison with NaN fails, and an
/// infinite corner makes the length infinite or NaN.
bool has_area(const Mesh& mesh, const Triangle& triangle) {
  const double length = glm::length(area_vector(mesh, triangle));
  return length > 0.0 && std::isfinite(length);
}

bool is_usable(const Vec3& normal) { return std::abs(glm::dot(normal, normal) - 1.0F) < 1e-3F; }

/// Returns how many normals it repaired.
std::size_t repair_normals(Mesh& mesh) {
  const auto broken = static_cast<std::size_t>(
      std::count_if(mesh.normals.begin(), mesh.normals.end(),
                    [](const Vec3& normal) { return !is_usable(normal); }));
  if (broken == 0) {
    return 0;
  }
  std::vector<DVec3> around(mesh.positions.size(), DVec3(0.0));
  for (const Triangle& triangle : mesh.triangles) {
    const DVec3 area = area_vector(mesh, triangle);
    for (const std::uint32_t vertex : triangle) {
      around[vertex] += area;
    }
  }
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (!is_usable(mesh.normals[i])) {
      const double length = glm::length(around[i]);
      mesh.normals[i] = length > 0.0 ? Vec3(around[i] / length) : Vec3(0.0F, 1.0F, 0.0F);
    }
  }
  return broken;
}

}  // namespace

std::optional<Mesh> read_primitive(const tinygltf::Model& model,
                                   const tinygltf::Primitive& primitive, std::optional<int> uv_set,
                                   const std::string& place, Warnings& warnings) {
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    warnings.add("points and lines are not shown", place);
    return std::nullopt;
  }
  const int position = attribute(primitive, "POSITION");
  if (position < 0) {
    warnings.add("primitives without POSITION are not shown", place);
    return std::nullopt;
  }
  const std::size_t vertex_count = element_count(model, position);
  const std::string position_place = place + ".attributes.POSITION";
  if (primitive.indices < 0) {
    // Before the vertices are numbered, so that a stated count without data costs no memory.
    read_vectors(model, position, {}, position_place);
  }
  Mesh mesh;
  mesh.triangles =
      triangles_of(vertex_order(model, primitive, vertex_count, place), primitive.mode);
  if (mesh.triangles.empty()) {
    warnings.add("primitives without a whole triangle are not shown", place);
    return std::nullopt;
  }
  const ElementRange used = rebase_on_used_range(mesh.triangles, vertex_count, place);
  mesh.positions = read_vectors(model, position, used, position_place);
  if (const int normal = attribute(primitive, "NORMAL"); normal >= 0) {
    const std::string normal_place = place + ".attributes.NORMAL";
    require_count(model, normal, vertex_count, normal_place);
    mesh.normals = read_vectors(model, normal, used, normal_place);
  }
  if (uv_set) {
    const std::string name = fmt::format("TEXCOORD_{}", *uv_set);
    if (const int uv = attribute(primitive, name); uv >= 0) {
      const std::string uv_place = fmt::format("{}.attributes.{}", place, name);
      require_count(model, uv, vertex_count, uv_place);
      mesh.uv_sets = {read_texture_coordinates(model, uv, used, uv_place)};
    } else {
      warnings.add("texture coordinates are missing: a textured material shows no texture", place);
    }
  }
  if (attribute(primitive, "COLOR_0") >= 0) {
    warnings.add("vertex colours are ignored", place);
  }
  if (!primitive.targets.empty()) {
    warnings.add("morph targets are ignored", place);
  }
  drop_unused_vertices(mesh);
  return mesh;
}

void bake(Mesh& mesh, const DMat4& world_from_local, const std::string& place, Warnings& warnings) {
  const DMat3 linear(world_from_local);
  const DVec3 translation(world_from_local[3]);
  for (Vec3& position : mesh.positions) {
    position = Vec3(linear * DVec3(position) + translation);
  }
  const DMat3 turn = normal_transform(linear);
  for (Vec3& normal : mesh.normals) {
    normal = Vec3(glm::normalize(turn * DVec3(normal)));
  }
  if (glm::determinant(linear) < 0.0) {
    for (Triangle& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  const std::size_t dropped = std::erase_if(
      mesh.triangles, [&](const Triangle& triangle) { return !has_area(mesh, triangle); });
  if (dropped > 0) {
    warnings.add("triangles without area or with coordinates that are not finite are dropped",
                 place, dropped);
    drop_unused_vertices(mesh);
  }
  warnings.add("normals of no use are replaced by those of the surface", place,
               repair_normals(mesh));
}

}  // namespace foveola
