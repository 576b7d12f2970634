// Converts glTF primitives to triangle meshes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/gltf/model.h"
#include "renderer/scene/gltf_mesh/deformation.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// Bounds the memory for a file's geometry by the file's size: 512 MiB, and 32 bytes for each byte
/// of its buffers. Primitives may share vertices and nodes may share meshes, so that a small file
/// can name any number of triangles.
class MemoryBudget {
 public:
  explicit MemoryBudget(const GltfModel& model);

  /// Throws GltfFault at `place` if the budget is exceeded.
  void take(std::size_t bytes, const std::string& place);

 private:
  std::size_t left_;
};

/// Memory of a mesh's vertices and triangles.
std::size_t bytes_of(const Mesh& mesh);

/// The vertex attributes that a primitive's material needs.
struct VertexNeeds {
  std::vector<int> uv_sets;  ///< indices of TEXCOORD, in the order of the future Mesh::uv_sets
  std::optional<TextureUse> normal_texture;
};

/// The renderable triangles of `primitive` in its own space, with only their own vertices;
/// deformed; material and name are not set. nullopt, with a warning, if there are none. Throws
/// GltfFault, with places below `place`, the primitive's JSON path.
std::optional<Mesh> read_primitive(const GltfModel& model, const GltfPrimitive& primitive,
                                   const VertexNeeds& needs, const Deformation& deformation,
                                   const std::string& place, MemoryBudget& budget,
                                   Warnings& warnings);

}  // namespace foveola
