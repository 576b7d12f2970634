// Which images a glTF file's materials use, and how: decoded once for each encoding.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/scene/gltf_file.h"
#include "renderer/scene/gltf_images.h"
#include "renderer/scene/kept_parts.h"
#include "renderer/scene/scene_hash.h"
#include "renderer/scene/texture.h"
#include "renderer/scene/texture_list.h"

namespace tinygltf {
class Model;
}

namespace foveola {

enum class Encoding : std::uint8_t { linear, srgb };

class TextureSet {
 public:
  /// Both must outlive this. kept: where decoded images are found and left, or null.
  explicit TextureSet(const GltfFile& file, KeptParts<Texels>* kept = nullptr)
      : model_(*file.model), images_(file), kept_(kept) {}

  /// The index, into what decode() will return, of glTF texture `texture` with colours in
  /// `encoding`; -1 for -1. Throws GltfFault if the texture has no image or that cannot be read.
  int add(int texture, Encoding encoding);

  /// All textures that were added. Throws GltfFault if an image cannot be decoded or all together
  /// take more memory than require_modest_memory grants.
  std::vector<Texture> decode() const;

  /// SHA-256s of the files of the images that are used.
  FileHashes image_hashes() const { return images_.hashes(); }

 private:
  struct Content {
    int image = -1;
    Encoding encoding = Encoding::linear;

    auto operator<=>(const Content&) const = default;
  };

  void require_modest_size() const;
  Texels texels_of(const Content& content, bool with_mips) const;
  /// The same, found among those kept or made and kept.
  std::shared_ptr<const Texels> shared_texels_of(const Content& content, bool with_mips) const;

  const tinygltf::Model& model_;
  GltfImages images_;
  KeptParts<Texels>* kept_;
  TextureList<Content> textures_;
};

}  // namespace foveola
