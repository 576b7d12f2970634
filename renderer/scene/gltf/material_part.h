// Reads the properties of one glTF material, with limits, warnings and textures.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "renderer/scene/gltf/textures.h"
#include "renderer/scene/gltf_file/values.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// Data shared by the parts of one material.
class MaterialContext {
 public:
  /// textures: null for an unused material, whose textures are not loaded. Both references must
  /// outlive this.
  MaterialContext(std::string place, TextureSet* textures, Warnings& warnings)
      : place_(std::move(place)), textures_(textures), warnings_(warnings) {}

  /// `value` clamped to [lowest, highest], with a warning that names `property`, its JSON path
  /// below the material. Both limits are within a float's range.
  float limited(double value, double lowest, double highest, const std::string& property);
  Rgb limited(const DVec3& value, double lowest, double highest, const std::string& property);

  /// The texture of a textureInfo; an absent one has none.
  TextureUse use(const GltfValues& info, Encoding encoding);
  /// A roughness texture of 1 - `factor` times the glossiness in the image's alpha.
  TextureUse use_glossiness(const GltfValues& info, float factor);

  void warn(const std::string& what, const std::string& property);

  /// The TEXCOORDs of the textures used so far, indexed by TextureUse::uv_set.
  const std::vector<int>& uv_sets() const { return uv_sets_; }

 private:
  /// texture: the index in the TextureSet.
  TextureUse use_of(const GltfValues& info, int texture);

  std::string place_;
  TextureSet* textures_;
  Warnings& warnings_;
  std::vector<int> uv_sets_;
};

/// An object of a material: the material itself, or one in it.
class MaterialPart {
 public:
  /// path: the JSON path of `values` below the material, ending with a point.
  MaterialPart(const GltfValues& values, std::string path, MaterialContext& context)
      : values_(values), path_(std::move(path)), context_(context) {}

  MaterialPart object(const char* name) const {
    return {values_.object(name), path_ + name + ".", context_};
  }
  MaterialPart extension(const char* name) const {
    return {values_.extension(name), path_ + "extensions." + name + ".", context_};
  }

  const GltfValues& values() const { return values_; }
  MaterialContext& context() const { return context_; }
  std::string place_of(const std::string& property) const { return path_ + property; }

  float factor(const char* property, double absent) const {
    return context_.limited(values_.number(property, absent), 0.0, 1.0, place_of(property));
  }
  Rgb color(const char* property, double absent, double highest = 1.0) const {
    return context_.limited(values_.vec3(property, DVec3(absent)), 0.0, highest,
                            place_of(property));
  }
  /// The fourth component of a colour; 1 without a colour.
  float alpha(const char* color) const {
    return context_.limited(values_.element(color, 3, 1.0), 0.0, 1.0, place_of(color));
  }
  TextureUse texture(const char* property, Encoding encoding) const {
    return context_.use(values_.object(property), encoding);
  }
  float normal_scale(const std::string& texture) const;

 private:
  GltfValues values_;
  std::string path_;
  MaterialContext& context_;
};

}  // namespace foveola
