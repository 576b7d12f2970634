// Reads the properties of one extension of a glTF material.
#pragma once

#include <string>
#include <utility>

#include <tiny_gltf.h>

#include "renderer/scene/gltf/material_context.h"
#include "renderer/scene/gltf/values.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// An extension of a material, and how to read its properties.
class MaterialExtension {
 public:
  MaterialExtension(const tinygltf::Material& source, std::string name, MaterialContext& context)
      : name_(std::move(name)), values_(source.extensions, name_), context_(context) {}

  bool exists() const { return values_.exists(); }
  const GltfValues& values() const { return values_; }
  std::string place_of(const std::string& property) const {
    return "extensions." + name_ + "." + property;
  }

  float factor(const std::string& property, double absent, double highest = 1.0) const {
    return context_.limited(values_.number(property, absent), 0.0, highest, place_of(property));
  }
  Rgb color(const std::string& property, double absent, double highest = 1.0) const {
    return context_.limited(values_.vec3(property, DVec3(absent)), 0.0, highest,
                            place_of(property));
  }
  TextureReference reference(const std::string& property) const {
    const GltfValues info = values_.object(property);
    return {.index = info.integer("index", -1),
            .tex_coord = info.integer("texCoord", 0),
            .transform = info.object("extensions").get("KHR_texture_transform")};
  }
  TextureUse texture(const std::string& property, Encoding encoding) const {
    return context_.use(reference(property), encoding);
  }

 private:
  std::string name_;
  GltfValues values_;
  MaterialContext& context_;
};

}  // namespace foveola
