// The textures that an OBJ file's materials use: each decoded once for each use.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "renderer/scene/texture.h"

namespace foveola {

/// What a Texture is made of.
struct ObjTexture {
  enum class Content : std::uint8_t {
    plain,               ///< `first` as it is
    color_alpha,         ///< colour of `first`, or white, and alpha of `second`
    roughness_metallic,  ///< `first` in green and `second` in blue, where there are any
  };
  Content content = Content::plain;
  std::filesystem::path first;  ///< empty: none
  std::filesystem::path second;
  bool is_srgb = false;
  Wrap wrap = Wrap::repeat;

  auto operator<=>(const ObjTexture&) const = default;
};

class ObjTextureSet {
 public:
  /// The index of `texture` in what decode() will return.
  int add(const ObjTexture& texture);

  /// All textures that were added. Throws Error if an image is none, is damaged, or all together
  /// have more than 2^29 pixels.
  std::vector<Texture> decode() const;

  /// The images that the textures are made of, each once.
  std::set<std::filesystem::path> files() const;

 private:
  void require_modest_size() const;

  std::vector<ObjTexture> textures_;
  std::map<ObjTexture, int> index_of_;  ///< into textures_
};

}  // namespace foveola
