#include "renderer/scene/gltf/geometry.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/base/work/work_scope.h"
#include "renderer/scene/gltf/accessor.h"
#include "renderer/scene/gltf/fault.h"
#include "renderer/scene/mesh_edit.h"
#include "renderer/scene/tangents.h"

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
  triangles.reserve(order.size());
  for (std::size_t i = 0; i + 2 < order.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      triangles.push_back({order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]});
    } else {
      triangles.push_back({order[i + 1], order[i + 2], order[0]});
    }
  }
  return triangles;
}

std::uint32_t highest_vertex(const std::vector<Triangle>& triangles) {
  std::uint32_t highest = 0;
  for (const auto& [a, b, c] : triangles) {
    highest = std::max({highest, a, b, c});
  }
  return highest;
}

/// The vertices that `triangles` name, ascending and each once, found by marking them all.
std::vector<std::uint32_t> vertices_used_of_few(const std::vector<Triangle>& triangles,
                                                std::uint32_t highest) {
  std::vector<bool> is_used(std::size_t{highest} + 1, false);
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) {
      is_used[vertex] = true;
    }
  }
  std::vector<std::uint32_t> used;
  for (std::uint32_t vertex = 0; vertex < is_used.size(); ++vertex) {
    if (is_used[vertex]) {
      used.push_back(vertex);
    }
  }
  return used;
}

/// The same, in time and memory that do not depend on how many vertices there are.
std::vector<std::uint32_t> vertices_used_of_many(const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> used;
  used.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    used.insert(used.end(), triangle.begin(), triangle.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

/// Lets `triangles` count only the vertices that they use, and returns those, ascending. Many
/// primitives may share one large accessor, of which each reads no more. Throws if the triangles
/// name a vertex beyond `vertex_count`.
std::vector<std::uint32_t> renumber(std::vector<Triangle>& triangles, std::size_t vertex_count,
                                    const std::string& place) {
  const std::uint32_t highest = highest_vertex(triangles);
  if (highest >= vertex_count) {
    throw GltfFault(place + ".indices",
                    fmt::format("names vertex {}, but POSITION has {}", highest, vertex_count));
  }
  const bool are_few = highest < 16 * triangles.size();
  std::vector<std::uint32_t> used =
      are_few ? vertices_used_of_few(triangles, highest) : vertices_used_of_many(triangles);
  if (used.size() == std::size_t{highest} + 1) {
    return used;  // all of them: the numbers stay
  }
  for (Triangle& triangle : triangles) {
    for (std::uint32_t& vertex : triangle) {
      vertex = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), vertex) -
                                          used.begin());
    }
  }
  return used;
}

/// The vertex attributes of one primitive.
class Attributes {
 public:
  Attributes(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
             const std::string& place, std::size_t vertex_count, ElementList used)
      : model_(model),
        primitive_(primitive),
        place_(place),
        vertex_count_(vertex_count),
        used_(used) {}

  bool has(const std::string& name) const { return attribute(primitive_, name) >= 0; }

  /// The values of attribute `name` by one of the functions that read an accessor; none if the
  /// primitive lacks it.
  template <typename Value>
  std::vector<Value> read(const std::string& name,
                          std::vector<Value> (*read_accessor)(const tinygltf::Model&, int,
                                                              ElementList,
                                                              const std::string&)) const {
    const int accessor = attribute(primitive_, name);
    if (accessor < 0) {
      return {};
    }
    throw_if_work_stopped();
    const std::string place = fmt::format("{}.attributes.{}", place_, name);
    if (const std::size_t count = element_count(model_, accessor); count != vertex_count_) {
      throw GltfFault(place, fmt::format("accessors[{}] has {} elements, but POSITION has {}",
                                         accessor, count, vertex_count_));
    }
    return read_accessor(model_, accessor, used_, place);
  }

 private:
  const tinygltf::Model& model_;
  const tinygltf::Primitive& primitive_;
  const std::string& place_;
  std::size_t vertex_count_;
  ElementList used_;
};

void read_uv_sets(Mesh& mesh, const Attributes& attributes, const std::vector<int>& uv_sets,
                  const std::string& place, Warnings& warnings) {
  for (const int set : uv_sets) {
    const std::string name = fmt::format("TEXCOORD_{}", set);
    if (!attributes.has(name)) {
      warnings.add("texture coordinates are missing: a textured material shows no texture", place);
      mesh.uv_sets.clear();
      return;
    }
    mesh.uv_sets.push_back(attributes.read(name, read_vec2s));
  }
}

Mesh read_vertices(const Attributes& attributes, const VertexNeeds& needs, const std::string& place,
                   Warnings& warnings) {
  Mesh mesh;
  mesh.positions = attributes.read("POSITION", read_vec3s);
  mesh.normals = attributes.read("NORMAL", read_vec3s);
  mesh.colors = attributes.read("COLOR_0", read_colors);
  read_uv_sets(mesh, attributes, needs.uv_sets, place, warnings);
  const bool uses_tangents = needs.normal_texture && !mesh.uv_sets.empty();
  if (uses_tangents && !mesh.normals.empty()) {  // specification: without normals, ignore tangents
    mesh.tangents = attributes.read("TANGENT", read_vec4s);
  }
  return mesh;
}

void warn_of_what_is_ignored(const tinygltf::Primitive& primitive, const std::string& place,
                             Warnings& warnings) {
  if (attribute(primitive, "COLOR_1") >= 0) {
    warnings.add("vertex colours but the first are ignored", place);
  }
}

void mend(Mesh& mesh, const VertexNeeds& needs, const std::string& place, Warnings& warnings) {
  throw_if_work_stopped();
  warnings.add("triangles without area or with coordinates that are not finite are dropped", place,
               drop_degenerate_triangles(mesh));
  throw_if_work_stopped();
  warnings.add("normals of no use are replaced by those of the surface", place,
               repair_normals(mesh));
  warnings.add("texture coordinates that are not finite become 0", place, repair_uvs(mesh));
  warnings.add("vertex colours are limited to the range they may have", place, repair_colors(mesh));
  drop_white_colors(mesh);
  if (!needs.normal_texture || mesh.uv_sets.empty()) {
    return;
  }
  const std::size_t unusable = straighten_tangents(mesh);
  warnings.add("tangents of no use: all those of their mesh are computed", place, unusable);
  if (unusable > 0 || mesh.tangents.empty()) {
    add_tangents(mesh, needs.normal_texture->uv_set, needs.normal_texture->texture_from_mesh);
  }
}

}  // namespace

MemoryBudget::MemoryBudget(const tinygltf::Model& model) : left_(std::size_t{1} << 29) {
  for (const tinygltf::Buffer& buffer : model.buffers) {
    left_ += 32 * buffer.data.size();
  }
}

void MemoryBudget::take(std::size_t bytes, const std::string& place) {
  if (bytes > left_) {
    throw GltfFault(place, "brings the scene to more memory than a file of its size may ask for");
  }
  left_ -= bytes;
}

std::size_t bytes_of(const Mesh& mesh) {
  std::size_t bytes = sizeof(Mesh) + sizeof(Triangle) * mesh.triangles.size() +
                      sizeof(Vec3) * (mesh.positions.size() + mesh.normals.size()) +
                      sizeof(Vec4) * (mesh.tangents.size() + mesh.colors.size());
  for (const std::vector<Vec2>& uvs : mesh.uv_sets) {
    bytes += sizeof(Vec2) * uvs.size();
  }
  return bytes;
}

std::optional<Mesh> read_primitive(const tinygltf::Model& model,
                                   const tinygltf::Primitive& primitive, const VertexNeeds& needs,
                                   const Deformation& deformation, const std::string& place,
                                   MemoryBudget& budget, Warnings& warnings) {
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    warnings.add("points and lines are not shown", place);
    return std::nullopt;
  }
  const int position = attribute(primitive, "POSITION");
  if (position < 0) {
    warnings.add("primitives without POSITION are not shown", place);
    return std::nullopt;
  }
  throw_if_work_stopped();
  const std::size_t vertex_count = element_count(model, position);
  if (primitive.indices < 0) {
    // Before the vertices are numbered, so that a stated count without data costs no memory.
    read_vec3s(model, position, {}, place + ".attributes.POSITION");
  }
  std::vector<Triangle> triangles =
      triangles_of(vertex_order(model, primitive, vertex_count, place), primitive.mode);
  if (triangles.empty()) {
    warnings.add("primitives without a whole triangle are not shown", place);
    return std::nullopt;
  }
  throw_if_work_stopped();
  const std::vector<std::uint32_t> used = renumber(triangles, vertex_count, place);
  const Attributes attributes(model, primitive, place, vertex_count, used);
  Mesh mesh = read_vertices(attributes, needs, place, warnings);
  mesh.triangles = std::move(triangles);
  warn_of_what_is_ignored(primitive, place, warnings);
  budget.take(bytes_of(mesh), place);
  deform(mesh, model, primitive, deformation, used, vertex_count, place, warnings);
  mend(mesh, needs, place, warnings);
  if (mesh.triangles.empty()) {
    return std::nullopt;
  }
  return mesh;
}

}  // namespace foveola
