// Reads a glTF file's container, JSON, buffers and the images in it into tinygltf's model.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "renderer/scene/scene_hash.h"

namespace tinygltf {
class Model;
}

namespace foveola {

struct GltfFile {
  /// Every index in it is in range and every buffer view lies inside its buffer. Images in data:
  /// uris hold their encoded bytes in `image`, those in files of their own have them in `uri`;
  /// those in a buffer view are left there.
  std::shared_ptr<tinygltf::Model> model;
  std::filesystem::path folder;  ///< where uris begin; those of images do not lead out of it
  std::string sha256;            ///< SHA-256 of the file itself
  FileHashes buffer_hashes;      ///< SHA-256s of the files that hold buffers
};

/// Reads a .glb or .gltf file (distinguished by content) and the buffers in its folder that it
/// refers to. Throws Error if the file itself cannot be read, GltfFault if its content is wrong.
/// content: becomes the file's, and is used no more.
GltfFile read_gltf_file(const std::filesystem::path& path, std::string& content);

}  // namespace foveola
