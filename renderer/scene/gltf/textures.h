// Collects the textures of a glTF file's materials; each image is decoded once per encoding.
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

#include "renderer/scene/gltf_file/file.h"
#include "renderer/scene/kept_parts.h"
#include "renderer/scene/references.h"
#include "renderer/scene/scene_hash.h"
#include "renderer/scene/texture_list.h"
#include "renderer/scene/textures/texture.h"

namespace foveola {

enum class Encoding : std::uint8_t {
  linear,
  srgb,
  srgb_opacity,  ///< colours, and an alpha that is an opacity
  glossiness
};

/// A file's encoded images, read on first use.
class GltfImages {
 public:
  /// file: must outlive this.
  explicit GltfImages(const GltfFile& file) : file_(file) {}

  /// Reads image number `image` if it lies in its own file and has not been read. Throws GltfFault
  /// if it cannot.
  void load(int image);

  /// The decoded reference of an image in its own file; else empty.
  std::string reference_of(int image) const;

  /// The encoded bytes of a loaded image.
  std::span<const unsigned char> encoded(int image) const;

  /// Name of a loaded image in messages: its JSON path, and its file's name if it has one.
  std::string place_of(int image) const;

  /// Total size of the buffers, data: uris and files of the loaded images, each counted once.
  std::size_t encoded_bytes() const { return encoded_bytes_; }

  /// SHA-256s of the files read.
  FileHashes hashes() const;
  /// The missing files of images.
  const std::set<std::filesystem::path>& missing_files() const { return missing_files_; }

 private:
  void load_file(int image, const std::filesystem::path& path);

  const GltfFile& file_;
  std::set<int> loaded_;
  std::set<std::size_t> buffers_;  ///< indices of the buffers that hold images
  std::size_t encoded_bytes_ = 0;
  std::map<int, std::filesystem::path> paths_;             ///< by image, if it has its own file
  std::map<std::filesystem::path, std::string> contents_;  ///< by path
  std::set<std::filesystem::path> missing_files_;
};

class TextureSet {
 public:
  /// All must outlive this. kept: stores decoded images for reuse, or null. is_strict: whether a
  /// texture that cannot be shown is a GltfFault instead of a warning.
  TextureSet(const GltfFile& file, KeptParts<Texels>* kept, bool is_strict, Warnings& warnings)
      : model_(file.model),
        images_(file),
        kept_(kept),
        is_strict_(is_strict),
        warnings_(warnings) {}

  /// The index of glTF texture `texture` with colours in `encoding`, for TextureUse until decode()
  /// is called. -1 for -1, and if its image is absent or unreadable.
  int add(int texture, Encoding encoding);

  /// The same for a texture whose green is the roughness 1 - `factor` times the alpha of glTF
  /// texture `texture`.
  int add_glossiness(int texture, float factor);

  /// All added textures whose images can be decoded. Renumbers the textures of `materials`, and
  /// removes the others. Throws GltfFault if all together exceed require_modest_memory.
  std::vector<Texture> decode(std::vector<Material>& materials) const;

  /// SHA-256s of the used images' files.
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
  /// The same, reused from `kept` or made and kept.
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
