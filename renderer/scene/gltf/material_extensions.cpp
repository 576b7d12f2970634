#include "renderer/scene/gltf/material_extensions.h"

#include <cmath>
#include <limits>
#include <string>

#include <tiny_gltf.h>

#include "renderer/scene/gltf/material_extension.h"

namespace foveola {
namespace {

constexpr double brightest = 1e9;

/// Alpha is linear in any texture. Read as if the colours beside it were sRGB, it shares a texture
/// with those of the same extension, which exporters like to put into the same image.
constexpr Encoding only_alpha = Encoding::srgb;

float ior_of(const tinygltf::Material& source, MaterialContext& context) {
  /// The extension's value 0 makes the Fresnel term 1; so does, to within 4e-6, this index.
  constexpr double all_is_reflected = 1e6;
  const MaterialExtension extension(source, "KHR_materials_ior", context);
  const double ior = extension.values().number("ior", 1.5);
  return ior == 0.0 ? static_cast<float>(all_is_reflected)
                    : context.limited(ior, 1.0, all_is_reflected, extension.place_of("ior"));
}

void read_transmission(const tinygltf::Material& source, MaterialContext& context,
                       Material& material) {
  const MaterialExtension extension(source, "KHR_materials_transmission", context);
  material.transmission = extension.factor("transmissionFactor", 0.0);
  if (material.transmission > 0.0F) {
    material.transmission_texture = extension.texture("transmissionTexture", Encoding::linear);
  }
}

/// A thickness of 0 means thin walls. Any other only says that the mesh bounds a volume: how thick
/// it is, a path finds out.
void read_volume(const tinygltf::Material& source, MaterialContext& context, Material& material) {
  const MaterialExtension extension(source, "KHR_materials_volume", context);
  material.is_solid = extension.values().number("thicknessFactor", 0.0) > 0.0;
  if (!material.is_solid) {
    return;
  }
  material.attenuation_color = extension.color("attenuationColor", 1.0);
  const double infinity = std::numeric_limits<double>::infinity();
  const double distance = extension.values().number("attenuationDistance", infinity);
  if (!(distance > 0.0)) {
    context.warn("an attenuationDistance that is not positive is taken as infinite",
                 extension.place_of("attenuationDistance"));
  } else if (distance < static_cast<double>(std::numeric_limits<float>::max())) {
    material.attenuation_distance_m =
        std::max(static_cast<float>(distance), std::numeric_limits<float>::min());
  }
}

void read_specular(const tinygltf::Material& source, MaterialContext& context, Material& material) {
  const MaterialExtension extension(source, "KHR_materials_specular", context);
  material.specular = extension.factor("specularFactor", 1.0);
  material.specular_color = extension.color("specularColorFactor", 1.0, brightest);
  if (material.specular == 0.0F) {
    return;
  }
  material.specular_texture = extension.texture("specularTexture", only_alpha);
  if (max_component(material.specular_color) > 0.0F) {
    material.specular_color_texture = extension.texture("specularColorTexture", Encoding::srgb);
  }
}

void read_clearcoat(const tinygltf::Material& source, MaterialContext& context,
                    Material& material) {
  const MaterialExtension extension(source, "KHR_materials_clearcoat", context);
  material.clearcoat = extension.factor("clearcoatFactor", 0.0);
  material.clearcoat_roughness = extension.factor("clearcoatRoughnessFactor", 0.0);
  if (material.clearcoat == 0.0F) {
    return;
  }
  material.clearcoat_texture = extension.texture("clearcoatTexture", Encoding::linear);
  if (material.clearcoat_roughness > 0.0F) {
    material.clearcoat_roughness_texture =
        extension.texture("clearcoatRoughnessTexture", Encoding::linear);
  }
  if (const GltfValues normal = extension.values().object("clearcoatNormalTexture");
      normal.exists()) {
    material.clearcoat_normal_scale =
        context.limited(normal.number("scale", 1.0), -steepest_normal_scale, steepest_normal_scale,
                        extension.place_of("clearcoatNormalTexture.scale"));
    material.clearcoat_normal_texture =
        extension.texture("clearcoatNormalTexture", Encoding::linear);
  }
}

void read_sheen(const tinygltf::Material& source, MaterialContext& context, Material& material) {
  const MaterialExtension extension(source, "KHR_materials_sheen", context);
  material.sheen_color = extension.color("sheenColorFactor", 0.0);
  material.sheen_roughness = extension.factor("sheenRoughnessFactor", 0.0);
  if (max_component(material.sheen_color) == 0.0F) {
    return;
  }
  material.sheen_color_texture = extension.texture("sheenColorTexture", Encoding::srgb);
  if (material.sheen_roughness > 0.0F) {
    material.sheen_roughness_texture = extension.texture("sheenRoughnessTexture", only_alpha);
  }
}

}  // namespace

Rgb emission_of(const tinygltf::Material& source, MaterialContext& context) {
  const MaterialExtension extension(source, "KHR_materials_emissive_strength", context);
  const DVec3 factor(source.emissiveFactor[0], source.emissiveFactor[1], source.emissiveFactor[2]);
  const std::string place =
      extension.exists() ? extension.place_of("emissiveStrength") : "emissiveFactor";
  return context.limited(factor * extension.values().number("emissiveStrength", 1.0), 0.0,
                         brightest, place);
}

void read_material_extensions(const tinygltf::Material& source, MaterialContext& context,
                              Material& material) {
  material.ior = ior_of(source, context);
  read_transmission(source, context, material);
  read_volume(source, context, material);
  read_specular(source, context, material);
  read_clearcoat(source, context, material);
  read_sheen(source, context, material);
}

}  // namespace foveola
