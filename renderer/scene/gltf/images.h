// The encoded images of a glTF file, which are read when something uses them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>

#include "renderer/scene/gltf/file.h"
#include "renderer/scene/scene_hash.h"

namespace foveola {

class GltfImages {
 public:
  /// file: must outlive this.
  explicit GltfImages(const GltfFile& file) : file_(file) {}

  /// Reads image number `image` if it lies in a file of its own and has not been read. Throws
  /// GltfFault if that is not possible.
  void load(int image);

  /// What it is called where it lies in a file of its own, decoded; else empty, or a data: uri.
  std::string reference_of(int image) const;

  /// The PNG or JPEG bytes, or whatever they are, of an image that has been loaded.
  std::span<const unsigned char> encoded(int image) const;

  /// What a message calls an image that has been loaded: its JSON path, and its file's name where
  /// it has one.
  std::string place_of(int image) const;

  /// The size of the buffers, data: uris and files that the loaded images lie in, each counted
  /// once.
  std::size_t encoded_bytes() const { return encoded_bytes_; }

  /// SHA-256s of the files that were read.
  FileHashes hashes() const;
  /// The files that images were said to lie in, and that are not there.
  const std::set<std::filesystem::path>& missing_files() const { return missing_files_; }

 private:
  void load_file(int image, const std::filesystem::path& path);

  const GltfFile& file_;
  std::set<int> loaded_;
  std::set<int> buffers_;  ///< indices of the buffers that hold images
  std::size_t encoded_bytes_ = 0;
  std::map<int, std::filesystem::path> paths_;  ///< by image, where it has a file of its own
  std::map<std::filesystem::path, std::string> contents_;  ///< by path
  std::set<std::filesystem::path> missing_files_;
};

}  // namespace foveola
