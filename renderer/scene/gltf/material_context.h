// What reading one glTF material takes: limits with warnings, and the textures it uses.
#pragma once

#include <string>
#include <vector>

#include "renderer/scene/gltf/textures.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace tinygltf {
class Value;
}

namespace foveola {

/// Normal textures are scaled by at most so much.
inline constexpr double steepest_normal_scale = 1e3;

/// A glTF textureInfo.
struct TextureReference {
  int index = -1;  ///< -1: none
  int tex_coord = 0;
  const tinygltf::Value* transform = nullptr;  ///< KHR_texture_transform's, or null
};

/// Of an opaque material an alpha is ignored.
inline Encoding base_color_encoding(const Material& material) {
  return material.alpha_mode == AlphaMode::opaque ? Encoding::srgb : Encoding::srgb_opacity;
}

class MaterialContext {
 public:
  /// textures: null if nothing shows the material, whose textures are then not loaded. Both
  /// references must outlive this.
  MaterialContext(std::string place, TextureSet* textures, Warnings& warnings)
      : place_(std::move(place)), textures_(textures), warnings_(warnings) {}

  /// `value` in [lowest, highest], with a warning that names `property`, the value's JSON path
  /// below the material, if it was not. Both ends are within a float's range.
  float limited(double value, double lowest, double highest, const std::string& property);
  Rgb limited(const DVec3& value, double lowest, double highest, const std::string& property);

  TextureUse use(const TextureReference& reference, Encoding encoding);
  /// A texture of the roughness 1 - `factor` times the glossiness that the image has in its alpha.
  TextureUse use_glossiness(const TextureReference& reference, float factor);

  void warn(const std::string& what, const std::string& property);

  /// The TEXCOORDs of the textures used so far; TextureUse::uv_set counts them.
  const std::vector<int>& uv_sets() const { return uv_sets_; }

 private:
  /// add: gives the texture's index in the TextureSet.
  template <typename Add>
  TextureUse use_of(const TextureReference& reference, Add add);

  std::string place_;
  TextureSet* textures_;
  Warnings& warnings_;
  std::vector<int> uv_sets_;
};

}  // namespace foveola
