// Reads a glTF file's container, JSON, buffers and embedded images.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/scene/gltf/model.h"
#include "renderer/scene/scene_hash.h"

namespace foveola {

struct GltfFile {
  /// Every index is in range, and every used buffer view lies inside its buffer. Images in files of
  /// their own are not read.
  GltfModel model;
  std::filesystem::path folder;  ///< base of uris; those of images do not leave it
  std::string sha256;            ///< SHA-256 of the file itself
  FileHashes buffer_hashes;      ///< SHA-256s of the files that hold buffers
};

/// Reads a .glb or .gltf file (distinguished by content) and the buffers in its folder that it
/// refers to. Throws Error if the file itself cannot be read, GltfFault if its content is wrong.
/// content: reused for the file's content; undefined afterwards.
GltfFile read_gltf_file(const std::filesystem::path& path, std::string& content);

}  // namespace foveola
