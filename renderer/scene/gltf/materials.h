// Reads glTF's materials and their textures.
#pragma once

#include <filesystem>
#include <set>
#include <vector>

#include "renderer/scene/gltf_file/file.h"
#include "renderer/scene/gltf_mesh/geometry.h"
#include "renderer/scene/kept_parts.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/scene_hash.h"
#include "renderer/scene/warnings.h"

namespace foveola {

struct GltfMaterials {
  /// In the file's order, then the default material if a primitive has none.
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<VertexNeeds> needs;                 ///< needs of the meshes with each material
  FileHashes image_hashes;                        ///< SHA-256s of the image files in use
  std::set<std::filesystem::path> missing_files;  ///< of images in use

  /// The index into both for a primitive's `material`.
  std::size_t index_of(int material) const {
    return material >= 0 ? static_cast<std::size_t>(material) : materials.size() - 1;
  }
};

/// Reads all materials, and decodes in parallel the images of used ones. is_shown: for each
/// material of the file, whether the scene uses it; others have no textures. kept: stores decoded
/// images for reuse, or null. is_strict: whether a texture that cannot be shown is a GltfFault
/// instead of a warning. Throws GltfFault.
GltfMaterials read_materials(const GltfFile& file, const std::vector<bool>& is_shown,
                             KeptParts<Texels>* kept, bool is_strict, Warnings& warnings);

}  // namespace foveola
