// glTF's metallic-roughness materials and the textures that they use.
#pragma once

#include <optional>
#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace tinygltf {
class Model;
}

namespace foveola {

struct GltfMaterials {
  /// As in the file, then the default material if there is a primitive without one.
  std::vector<Material> materials;
  std::vector<Texture> textures;
  /// For each material, which TEXCOORD its textures read; none where it has no texture.
  std::vector<std::optional<int>> uv_sets;
};

/// Reads all materials and decodes, in parallel, the images that they use. Throws GltfFault.
GltfMaterials read_materials(const tinygltf::Model& model, Warnings& warnings);

}  // namespace foveola
