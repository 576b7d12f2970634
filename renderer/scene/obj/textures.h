// The textures that an OBJ file's materials use: each decoded once.
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

/// What a texture's texels are made of.
struct ObjTexture {
  enum class Content : std::uint8_t {
    unchanged,           ///< `first` as it is
    color_alpha,         ///< colour of `first`, or white, and alpha of `second`
    roughness_metallic,  ///< `first` in green and `second` in blue, where there are any
  };
  Content content = Content::unchanged;
  std::filesystem::path first;  ///< empty: none
  std::filesystem::path second;
  bool is_srgb = false;

  auto operator<=>(const ObjTexture&) const = default;
};

/// Whether the image at `file` can be decoded and has other colours than greys: a bump map that has
/// is a normal map.
bool has_colors(const std::filesystem::path& file);

class ObjTextureSet {
 public:
  /// The index, in what decode() will return, of `texture` continued by `wrap`.
  int add(const ObjTexture& texture, Wrap wrap);

  /// All textures that were added and whose images can be decoded. `materials` then count these,
  /// and use no others. place: the scene's, for messages. is_strict: whether an image that cannot
  /// be decoded is an Error instead of a warning. kept: where decoded images are found and left, or
  /// null. Throws Error if all together take more memory than require_modest_memory grants.
  std::vector<Texture> decode(std::vector<Material>& materials, KeptParts<Texels>* kept,
                              const std::string& place, bool is_strict, Warnings& warnings) const;

  /// The images that the textures are made of, each once.
  std::set<std::filesystem::path> files() const;

 private:
  void require_modest_size(const std::string& place) const;

  TextureList<ObjTexture> textures_;
};

}  // namespace foveola
