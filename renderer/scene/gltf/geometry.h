// Triangles out of glTF primitives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/gltf/deformation.h"
#include "renderer/scene/gltf/model.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// Bounds the memory that a file may ask for by the file's own size: 512 MiB, and 32 bytes for each
/// of its buffers'. Vertices may be shared by primitives and meshes by nodes, so that a small file
/// can name any number of triangles.
class MemoryBudget {
 public:
  explicit MemoryBudget(const GltfModel& model);

  /// Throws GltfFault, naming `place`, when more than everything has been taken.
  void take(std::size_t bytes, const std::string& place);

 private:
  std::size_t left_;
};

/// What `mesh` costs, vertices and triangles.
std::size_t bytes_of(const Mesh& mesh);

/// What a primitive's material needs of its vertices.
struct VertexNeeds {
  std::vector<int> uv_sets;  ///< which TEXCOORDs, in the order of the future Mesh::uv_sets
  std::optional<TextureUse> normal_texture;
};

/// The triangles of `primitive` in its own space, with the vertices that they use and no others,
/// and none that could not be rendered; deformed; material and name are left alone. Empty, with a
/// warning, where there are none. Throws GltfFault, with places below `place`, the primitive's JSON
/// path.
std::optional<Mesh> read_primitive(const GltfModel& model, const GltfPrimitive& primitive,
                                   const VertexNeeds& needs, const Deformation& deformation,
                                   const std::string& place, MemoryBudget& budget,
                                   Warnings& warnings);

}  // namespace foveola
