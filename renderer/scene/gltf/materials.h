// glTF's materials and the textures that they use.
#pragma once

#include <filesystem>
#include <set>
#include <vector>

#include "renderer/scene/gltf/file.h"
#include "renderer/scene/gltf/geometry.h"
#include "renderer/scene/kept_parts.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/scene_hash.h"
#include "renderer/scene/warnings.h"

namespace foveola {

struct GltfMaterials {
  /// As in the file, then the default material if there is a primitive without one.
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<VertexNeeds> needs;                 ///< what the meshes with each material need
  FileHashes image_hashes;                        ///< SHA-256s of the image files in use
  std::set<std::filesystem::path> missing_files;  ///< of images in use

  /// The index into both of what a primitive calls `material`.
  std::size_t index_of(int material) const {
    return material >= 0 ? static_cast<std::size_t>(material) : materials.size() - 1;
  }
};

/// Reads all materials, and decodes, in parallel, the images that those in use need. is_shown: for
/// each material of the file, whether anything in the scene has it; the others come without
/// textures. kept: where decoded images are found and left, or null. is_strict: whether a texture
/// that cannot be shown is a GltfFault instead of a warning. Throws GltfFault.
GltfMaterials read_materials(const GltfFile& file, const std::vector<bool>& is_shown,
                             KeptParts<Texels>* kept, bool is_strict, Warnings& warnings);

}  // namespace foveola
