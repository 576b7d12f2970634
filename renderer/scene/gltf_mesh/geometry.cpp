#include "renderer/scene/gltf_mesh/geometry.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/work/work_scope.h"
#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_mesh/accessor.h"
#include "renderer/scene/prepare/mesh_edit.h"
#include "renderer/scene/prepare/tangents.h"

namespace foveola {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::vector<std::uint32_t> vertex_order(const GltfModel& model, const GltfPrimitive& primitive,
                                        std::size_t vertex_count, const std::string& place) {
  if (primitive.indices >= 0) {
    return read_indices(model, primitive.indices, place + ".indices");
  }
  std::vector<std::uint32_t> order(vertex_count);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

/// Groups vertices into triangles by the topologies of the specification, section 3.7.2.1.
std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& order, GltfMode mode) {
  std::vector<Triangle> triangles;
  if (mode == GltfMode::triangles) {
    triangles.reserve(order.size() / 3);
    for (std::size_t i = 0; i + 2 < order.size(); i += 3) {
      triangles.push_back({order[i], order[i + 1], order[i + 2]});
    }
    return triangles;
  }
  triangles.reserve(order.size());
  for (std::size_t i = 0; i + 2 < order.size(); ++i) {
    if (mode == GltfMode::triangle_strip) {
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

/// The vertices of `triangles`, ascending and each once, found by marking them all.
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

/// The same, in time and memory independent of the number of vertices.
std::vector<std::uint32_t> vertices_used_of_many(const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> used;
  used.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    used.insert(used.end(), triangle.begin(), triangle.end());
  }
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

/// Renumbers `triangles` to the vertices that they use, and returns those, ascending. Many
/// primitives may share a large accessor, of which each reads only its part. Throws for a vertex
/// beyond `vertex_count`.
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
  Attributes(const VertexReader& reader, const GltfPrimitive& primitive, const std::string& place)
      : reader_(reader), primitive_(primitive), place_(place) {}

  bool has(const std::string& name) const { return primitive_.attribute(name) >= 0; }

  /// The values of attribute `name`, read by an accessor function; empty if the primitive lacks it.
  template <typename Value>
  std::vector<Value> read(const std::string& name, AccessorFunction<Value> read_accessor) const {
    if (!has(name)) {
      return {};
    }
    throw_if_work_stopped();
    return reader_.read(read_accessor, primitive_.attribute(name),
                        fmt::format("{}.attributes.{}", place_, name));
  }

 private:
  const VertexReader& reader_;
  const GltfPrimitive& primitive_;
  const std::string& place_;
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

void warn_of_what_is_ignored(const GltfPrimitive& primitive, const std::string& place,
                             Warnings& warnings) {
  if (primitive.attribute("COLOR_1") >= 0) {
    warnings.add("vertex colours other than the first are ignored", place);
  }
}

void mend(Mesh& mesh, const VertexNeeds& needs, const std::string& place, Warnings& warnings) {
  throw_if_work_stopped();
  warnings.add("triangles without area or with coordinates that are not finite are dropped", place,
               drop_degenerate_triangles(mesh));
  throw_if_work_stopped();
  warnings.add("invalid normals are replaced by the surface's", place, repair_normals(mesh));
  warnings.add("texture coordinates that are not finite become 0", place, repair_uvs(mesh));
  warnings.add("vertex colours are clamped to their range", place, repair_colors(mesh));
  drop_white_colors(mesh);
  if (!needs.normal_texture || mesh.uv_sets.empty()) {
    return;
  }
  const std::size_t unusable = straighten_tangents(mesh);
  warnings.add("invalid tangents: all tangents of their mesh are recomputed", place, unusable);
  if (unusable > 0 || mesh.tangents.empty()) {
    add_tangents(mesh, needs.normal_texture->uv_set, needs.normal_texture->texture_from_mesh);
  }
}

}  // namespace

MemoryBudget::MemoryBudget(const GltfModel& model) : left_(std::size_t{1} << 29) {
  for (const GltfBytes& buffer : model.buffers) {
    left_ += 32 * buffer.size();
  }
}

void MemoryBudget::take(std::size_t bytes, const std::string& place) {
  if (bytes > left_) {
    throw GltfFault(place, "the scene needs more memory than a file of its size may request");
  }
  left_ -= bytes;
}

std::size_t bytes_of(const Mesh& mesh) { return sizeof(Mesh) + array_bytes(mesh); }

std::optional<Mesh> read_primitive(const GltfModel& model, const GltfPrimitive& primitive,
                                   const VertexNeeds& needs, const Deformation& deformation,
                                   const std::string& place, MemoryBudget& budget,
                                   Warnings& warnings) {
  if (primitive.mode < GltfMode::triangles) {
    warnings.add("points and lines are not shown", place);
    return std::nullopt;
  }
  const int position = primitive.attribute("POSITION");
  if (position < 0) {
    warnings.add("primitives without POSITION are not shown", place);
    return std::nullopt;
  }
  throw_if_work_stopped();
  const std::size_t vertex_count = element_count(model, position);
  if (primitive.indices < 0) {
    // Before the vertices are numbered, so that a count without data costs no memory.
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
  const VertexReader reader(model, used, vertex_count);
  const Attributes attributes(reader, primitive, place);
  Mesh mesh = read_vertices(attributes, needs, place, warnings);
  mesh.triangles = std::move(triangles);
  warn_of_what_is_ignored(primitive, place, warnings);
  budget.take(bytes_of(mesh), place);
  deform(mesh, reader, primitive, deformation, place, warnings);
  mend(mesh, needs, place, warnings);
  if (mesh.triangles.empty()) {
    return std::nullopt;
  }
  return mesh;
}

}  // namespace foveola
