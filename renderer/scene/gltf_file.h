// Reads a glTF file's container, JSON, buffers and encoded images into tinygltf's model.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace tinygltf {
class Model;
}

namespace foveola {

struct GltfFile {
  /// Every index in it is in range and every buffer view lies inside its buffer. Images that come
  /// by uri hold their encoded bytes in `image`; those in a buffer view are left there.
  std::shared_ptr<const tinygltf::Model> model;
  std::string sha256;  ///< of the file and those it refers to: see scene_hash.h
};

/// Reads a .glb or .gltf file (told apart by content) and the files in its folder that it refers
/// to. Throws Error if the file itself cannot be read, GltfFault if its content is wrong.
GltfFile read_gltf_file(const std::filesystem::path& path);

}  // namespace foveola
