// Which images a glTF file's materials use, and how: decoded once for each encoding.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "renderer/scene/gltf/file.h"
#include "renderer/scene/kept_parts.h"
#include "renderer/scene/references.h"
#include "renderer/scene/scene_hash.h"
#include "renderer/scene/texture_list.h"
#include "renderer/scene/textures/texture.h"

namespace foveola {

enum class Encoding : std::uint8_t {
  linear,
  srgb,
  srgb_opacity,  ///< colours, and an alpha that says how far they are there
  glossiness
};

/// A file's encoded images, which are read when something uses them.
class GltfImages {
 public:
  /// file: must outlive this.
  explicit GltfImages(const GltfFile& file) : file_(file) {}

  /// Reads image number `image` if it lies in a file of its own and has not been read. Throws
  /// GltfFault if that is not possible.
  void load(int image);

  /// What it is called where it lies in a file of its own, decoded; else empty.
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
  std::set<std::size_t> buffers_;  ///< indices of the buffers that hold images
  std::size_t encoded_bytes_ = 0;
  std::map<int, std::filesystem::path> paths_;  ///< by image, where it has a file of its own
  std::map<std::filesystem::path, std::string> contents_;  ///< by path
  std::set<std::filesystem::path> missing_files_;
};

class TextureSet {
 public:
  /// All must outlive this. kept: where decoded images are found and left, or null. is_strict:
  /// whether a texture that cannot be shown is a GltfFault instead of a warning.
  TextureSet(const GltfFile& file, KeptParts<Texels>* kept, bool is_strict, Warnings& warnings)
      : model_(file.model),
        images_(file),
        kept_(kept),
        is_strict_(is_strict),
        warnings_(warnings) {}

  /// The index, for TextureUse until decode() is called, of glTF texture `texture` with colours in
  /// `encoding`; -1 for -1, and if the texture has no image or that cannot be read.
  int add(int texture, Encoding encoding);

  /// The same of a texture whose green is the roughness 1 - `factor` times the alpha of glTF
  /// texture `texture`.
  int add_glossiness(int texture, float factor);

  /// All textures that were added and whose images can be decoded. `materials` then count these,
  /// and use no others. Throws GltfFault if all together take more memory than
  /// require_modest_memory grants.
  std::vector<Texture> decode(std::vector<Material>& materials) const;

  /// SHA-256s of the files of the images that are used.
  FileHashes image_hashes() const { return images_.hashes(); }
  const std::set<std::filesystem::path>& missing_files() const { return images_.missing_files(); }

 private:
  struct Content {
    int image = -1;
    Encoding encoding = Encoding::linear;
    float glossiness_factor = 1.0F;

    auto operator<=>(const Content&) const = default;
  };

  int add(int texture, Content content);
  GltfValues texture_at(int texture) const;
  int load(int texture);
  std::size_t decoded_bytes(const Content& content) const;
  void require_modest_size() const;
  Texels texels_of(const Content& content, bool with_mips) const;
  /// The same, found among those kept or made and kept.
  std::shared_ptr<const Texels> shared_texels_of(const Content& content, bool with_mips) const;
  std::string digest_of(const Content& content, bool with_mips) const;

  const GltfModel& model_;
  GltfImages images_;
  KeptParts<Texels>* kept_;
  bool is_strict_;
  Warnings& warnings_;
  ForeignReferences foreign_;
  TextureList<Content> textures_;
};

}  // namespace foveola
