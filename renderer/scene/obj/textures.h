// Collects the textures of an OBJ file's materials; each image is decoded once.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "renderer/scene/kept_parts.h"
#include "renderer/scene/texture_list.h"
#include "renderer/scene/textures/texture.h"

namespace foveola {

/// The sources of a texture's texels.
struct ObjTexture {
  enum class Content : std::uint8_t {
    unchanged,           ///< `first` unchanged
    color_alpha,         ///< colour of `first`, or white, and alpha of `second`
    roughness_metallic,  ///< `first` in green and `second` in blue, if present
  };
  Content content = Content::unchanged;
  std::filesystem::path first;  ///< empty: none
  std::filesystem::path second;
  bool is_srgb = false;

  auto operator<=>(const ObjTexture&) const = default;
};

/// Whether the image at `file` can be decoded and is not grey: such a bump map is a normal map.
bool has_colors(const std::filesystem::path& file);

class ObjTextureSet {
 public:
  /// The index, in the result of decode(), of `texture` with `wrap`.
  int add(const ObjTexture& texture, Wrap wrap);

  /// All added textures whose images can be decoded. Renumbers the textures of `materials`, and
  /// removes the others. place: the scene's, for messages. is_strict: whether an image that cannot
  /// be decoded is an Error instead of a warning. kept: stores decoded images for reuse, or null.
  /// Throws Error if all together exceed require_modest_memory.
  std::vector<Texture> decode(std::vector<Material>& materials, KeptParts<Texels>* kept,
                              const std::string& place, bool is_strict, Warnings& warnings) const;

  /// The textures' image files, each once.
  std::set<std::filesystem::path> files() const;

 private:
  void require_modest_size(const std::string& place) const;

  TextureList<ObjTexture> textures_;
};

}  // namespace foveola
