#include "renderer/scene/gltf_mesh/deformation.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/scene/gltf_file/fault.h"

namespace foveola {
namespace {

bool names_joints(const GltfPrimitive& primitive) {
  return primitive.attributes.contains("JOINTS_0") && primitive.attributes.contains("WEIGHTS_0");
}

template <typename Vector>
void add_weighted(std::vector<Vector>& values, const std::vector<Vec3>& differences, float weight) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      values[i][axis] += weight * differences[i][axis];
    }
  }
}

void morph(Mesh& mesh, const GltfIndices& target, float weight, const VertexReader& reader,
           const std::string& place, Warnings& warnings) {
  for (const auto& [name, accessor] : target) {
    const std::string where = fmt::format("{}.{}", place, name);
    if (name == "POSITION") {
      add_weighted(mesh.positions, reader.read(read_vec3s, accessor, where), weight);
    } else if (name == "NORMAL") {
      if (!mesh.normals.empty()) {
        add_weighted(mesh.normals, reader.read(read_vec3s, accessor, where), weight);
      }
    } else if (name == "TANGENT") {
      if (!mesh.tangents.empty()) {
        add_weighted(mesh.tangents, reader.read(read_vec3s, accessor, where), weight);
      }
    } else {
      warnings.add("morph targets move positions, normals and tangents only", where);
    }
  }
}

/// Weighted sums of joint matrices, one per vertex, and the sums of weights.
struct Blend {
  std::vector<DMat4> matrices;
  std::vector<double> weights;
};

/// Adds the four joints per vertex of set `set`.
void add_joints(Blend& blend, int set, const GltfPrimitive& primitive,
                const std::vector<DMat4>& joints, const VertexReader& reader,
                const std::string& place) {
  const std::string joints_name = fmt::format("JOINTS_{}", set);
  const std::string place_of_joints = fmt::format("{}.attributes.{}", place, joints_name);
  const std::string weights_name = fmt::format("WEIGHTS_{}", set);
  const std::vector<Vec4> indices =
      reader.read(read_vec4s, primitive.attributes.at(joints_name), place_of_joints);
  const std::vector<Vec4> weights =
      reader.read(read_vec4s, primitive.attributes.at(weights_name),
                  fmt::format("{}.attributes.{}", place, weights_name));
  for (std::size_t i = 0; i < indices.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      if (weights[i][k] == 0.0F) {
        continue;
      }
      const float index = indices[i][k];
      if (!(index >= 0.0F && index < static_cast<float>(joints.size()))) {
        throw GltfFault(place_of_joints,
                        fmt::format("names joint {}, but the skin has {}", index, joints.size()));
      }
      blend.matrices[i] +=
          static_cast<double>(weights[i][k]) * joints[static_cast<std::size_t>(index)];
      blend.weights[i] += static_cast<double>(weights[i][k]);
    }
  }
}

/// The matrix of normals for a matrix of surfaces: its cofactors, for any determinant.
DMat3 normal_matrix(const DMat4& matrix) {
  const DMat3 linear(matrix);
  return {glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
          glm::cross(linear[0], linear[1])};
}

void move_vertex(Mesh& mesh, std::size_t i, const DMat4& matrix) {
  mesh.positions[i] = Vec3(matrix * glm::dvec4(DVec3(mesh.positions[i]), 1.0));
  if (!mesh.normals.empty()) {
    const DVec3 normal = normal_matrix(matrix) * DVec3(mesh.normals[i]);
    mesh.normals[i] = Vec3(normal / glm::length(normal));  // NaN for length 0
  }
  if (!mesh.tangents.empty()) {
    const DVec3 tangent = DMat3(matrix) * DVec3(Vec3(mesh.tangents[i]));
    mesh.tangents[i] = Vec4(Vec3(tangent / glm::length(tangent)), mesh.tangents[i].w);
  }
}

void skin(Mesh& mesh, const GltfPrimitive& primitive, const std::vector<DMat4>& joints,
          const VertexReader& reader, const std::string& place) {
  const std::size_t count = mesh.positions.size();
  Blend blend{.matrices = std::vector<DMat4>(count, DMat4(0.0)),
              .weights = std::vector<double>(count, 0.0)};
  for (int set = 0; primitive.attributes.contains(fmt::format("JOINTS_{}", set)) &&
                    primitive.attributes.contains(fmt::format("WEIGHTS_{}", set));
       ++set) {
    add_joints(blend, set, primitive, joints, reader, place);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (blend.weights[i] > 0.0) {
      move_vertex(mesh, i, blend.matrices[i] / blend.weights[i]);
    }
  }
}

}  // namespace

bool is_skinned(const GltfModel& model, const GltfNode& node) {
  if (node.skin < 0 || node.mesh < 0) {
    return false;
  }
  const auto& primitives = model.meshes[static_cast<std::size_t>(node.mesh)].primitives;
  return std::ranges::all_of(primitives, names_joints);
}

void separate_deformed_meshes(GltfModel& model) {
  constexpr std::size_t max_copies = std::size_t{1} << 20;
  std::vector<std::size_t> users(model.meshes.size(), 0);
  for (const GltfNode& node : model.nodes) {
    if (node.mesh >= 0) {
      ++users[static_cast<std::size_t>(node.mesh)];
    }
  }
  std::size_t copies = 0;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    GltfNode& node = model.nodes[i];
    if (node.mesh < 0 || (node.weights.empty() && !is_skinned(model, node))) {
      continue;
    }
    const auto mesh = static_cast<std::size_t>(node.mesh);
    if (users[mesh] > 1) {
      --users[mesh];
      copies += model.meshes[mesh].primitives.size();
      if (copies > max_copies) {
        throw GltfFault(
            fmt::format("nodes[{}]", i),
            fmt::format("the scene needs more than {} deformed copies of primitives", max_copies));
      }
      node.mesh = static_cast<int>(model.meshes.size());
      model.meshes.push_back(GltfMesh(model.meshes[mesh]));
    }
    if (!node.weights.empty()) {
      model.meshes[static_cast<std::size_t>(node.mesh)].weights = node.weights;
    }
  }
}

Deformation deformation_of(const GltfModel& model, const GltfNode& node,
                           const std::vector<DMat4>& world_from_node) {
  Deformation deformation{.weights = model.meshes[static_cast<std::size_t>(node.mesh)].weights,
                          .joints = {}};
  if (!is_skinned(model, node)) {
    return deformation;
  }
  const GltfValues source = model.root().item("skins", static_cast<std::size_t>(node.skin));
  const std::vector<int> joints = source.integers("joints");
  const std::string place = fmt::format("skins[{}]", node.skin);
  std::vector<float> inverse;
  if (const int accessor = source.integer("inverseBindMatrices"); accessor >= 0) {
    inverse = read_numbers(model, accessor, 16, place + ".inverseBindMatrices");
    if (inverse.size() < 16 * joints.size()) {
      throw GltfFault(
          place + ".inverseBindMatrices",
          fmt::format("has {} matrices for {} joints", inverse.size() / 16, joints.size()));
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const DMat4& world_from_joint = world_from_node[static_cast<std::size_t>(joints[i])];
    deformation.joints.push_back(
        inverse.empty() ? world_from_joint
                        : world_from_joint * DMat4(glm::make_mat4(inverse.data() + 16 * i)));
  }
  return deformation;
}

void deform(Mesh& mesh, const VertexReader& reader, const GltfPrimitive& primitive,
            const Deformation& deformation, const std::string& place, Warnings& warnings) {
  const std::size_t targets = std::min(primitive.targets.size(), deformation.weights.size());
  for (std::size_t i = 0; i < targets; ++i) {
    if (deformation.weights[i] != 0.0) {
      morph(mesh, primitive.targets[i], static_cast<float>(deformation.weights[i]), reader,
            fmt::format("{}.targets[{}]", place, i), warnings);
    }
  }
  if (!deformation.joints.empty()) {
    skin(mesh, primitive, deformation.joints, reader, place);
  }
}

}  // namespace foveola
