#include "renderer/scene/gltf/specular_glossiness.h"

#include <tiny_gltf.h>

#include "renderer/scene/gltf/material_extension.h"

namespace foveola {
namespace {

constexpr const char* extension_name = "KHR_materials_pbrSpecularGlossiness";

/// What a dielectric of index 1.5 reflects at normal incidence.
constexpr float usual_reflectance = 0.04F;

}  // namespace

bool has_specular_glossiness(const tinygltf::Material& source) {
  return source.extensions.contains(extension_name);
}

void read_specular_glossiness(const tinygltf::Material& source, MaterialContext& context,
                              Material& material) {
  const MaterialExtension extension(source, extension_name, context);
  material.base_color = extension.color("diffuseFactor", 1.0);
  material.alpha = context.limited(extension.values().element("diffuseFactor", 3, 1.0), 0.0, 1.0,
                                   extension.place_of("diffuseFactor"));
  material.base_color_texture = extension.texture("diffuseTexture", base_color_encoding(material));
  material.metallic = 0.0F;
  material.specular_color = extension.color("specularFactor", 1.0) / usual_reflectance;
  material.specular_color_texture = extension.texture("specularGlossinessTexture", Encoding::srgb);
  const float glossiness = extension.factor("glossinessFactor", 1.0);
  material.metallic_roughness_texture =
      context.use_glossiness(extension.reference("specularGlossinessTexture"), glossiness);
  material.roughness = material.metallic_roughness_texture.exists() ? 1.0F : 1.0F - glossiness;
}

}  // namespace foveola
