// The encoded images of a glTF file, which are read when something uses them.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "renderer/scene/gltf_file.h"
#include "renderer/scene/scene_hash.h"

namespace foveola {

class GltfImages {
 public:
  /// file: must outlive this.
  explicit GltfImages(const GltfFile& file) : file_(file) {}

  /// Reads image number `image` if it lies in a file of its own and has not been read. Throws
  /// GltfFault if that is not possible.
  void load(int image);

  /// The PNG or JPEG bytes, or whatever they are, of an image that has been loaded.
  std::span<const unsigned char> encoded(int image) const;

  /// Of the files that were read.
  FileHashes hashes() const;

 private:
  const GltfFile& file_;
  std::map<int, std::filesystem::path> paths_;             ///< of images in files of their own
  std::map<std::filesystem::path, std::string> contents_;  ///< of those files
};

}  // namespace foveola
