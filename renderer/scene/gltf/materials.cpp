#include "renderer/scene/gltf/materials.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "renderer/scene/gltf/material_part.h"
#include "renderer/scene/gltf/textures.h"

namespace foveola {
namespace {

constexpr double brightest = 1e9;

/// Alpha is linear in any texture. With the encoding of the same extension's sRGB colours, it
/// shares their texture, since exporters often store both in one image.
constexpr Encoding only_alpha = Encoding::srgb;

/// An opaque material ignores alpha.
Encoding base_color_encoding(const Material& material) {
  return material.alpha_mode == AlphaMode::opaque ? Encoding::srgb : Encoding::srgb_opacity;
}

AlphaMode alpha_mode_of(const std::string& name) {
  if (name == "BLEND") {
    return AlphaMode::blend;
  }
  return name == "MASK" ? AlphaMode::mask : AlphaMode::opaque;
}

void read_base_color(const MaterialPart& pbr, Material& material) {
  material.base_color = pbr.color("baseColorFactor", 1.0);
  material.alpha = pbr.alpha("baseColorFactor");
  const bool is_black = max_component(material.base_color) == 0.0F;
  if (!is_black || material.alpha_mode != AlphaMode::opaque) {
    material.base_color_texture = pbr.texture("baseColorTexture", base_color_encoding(material));
  }
}

void read_metallic_roughness(const MaterialPart& pbr, Material& material) {
  material.metallic = pbr.factor("metallicFactor", 1.0);
  material.roughness = pbr.factor("roughnessFactor", 1.0);
  if (material.metallic > 0.0F || material.roughness > 0.0F) {
    material.metallic_roughness_texture = pbr.texture("metallicRoughnessTexture", Encoding::linear);
  }
}

void read_normal_texture(const MaterialPart& source, Material& material) {
  if (!source.values().has("normalTexture")) {
    return;
  }
  material.normal_scale = source.normal_scale("normalTexture");
  if (material.normal_scale != 0.0F) {
    material.normal_texture = source.texture("normalTexture", Encoding::linear);
  }
}

/// emissiveFactor times KHR_materials_emissive_strength's factor.
void read_emission(const MaterialPart& source, Material& material) {
  const MaterialPart extension = source.extension("KHR_materials_emissive_strength");
  const std::string place = extension.values().exists() ? extension.place_of("emissiveStrength")
                                                        : source.place_of("emissiveFactor");
  material.emission =
      source.context().limited(source.values().vec3("emissiveFactor", DVec3(0.0)) *
                                   extension.values().number("emissiveStrength", 1.0),
                               0.0, brightest, place);
  if (material.is_emissive()) {
    material.emissive_texture = source.texture("emissiveTexture", Encoding::srgb);
  }
}

void read_ior(const MaterialPart& extension, Material& material) {
  /// The extension's value 0 makes the Fresnel term 1; this index does so within 4e-6.
  constexpr double all_is_reflected = 1e6;
  const double ior = extension.values().number("ior", 1.5);
  material.ior = ior == 0.0 ? static_cast<float>(all_is_reflected)
                            : extension.context().limited(ior, 1.0, all_is_reflected,
                                                          extension.place_of("ior"));
}

void read_transmission(const MaterialPart& extension, Material& material) {
  material.transmission = extension.factor("transmissionFactor", 0.0);
  if (material.transmission > 0.0F) {
    material.transmission_texture = extension.texture("transmissionTexture", Encoding::linear);
  }
}

/// A thickness of 0 means thin walls. Any other means only that the mesh bounds a volume: paths
/// find its thickness.
void read_volume(const MaterialPart& extension, Material& material) {
  material.is_solid = extension.values().number("thicknessFactor", 0.0) > 0.0;
  if (!material.is_solid) {
    return;
  }
  material.attenuation_color = extension.color("attenuationColor", 1.0);
  const double infinity = std::numeric_limits<double>::infinity();
  const double distance = extension.values().number("attenuationDistance", infinity);
  if (!(distance > 0.0)) {
    extension.context().warn("an attenuationDistance that is not positive is taken as infinite",
                             extension.place_of("attenuationDistance"));
  } else if (distance < static_cast<double>(std::numeric_limits<float>::max())) {
    material.attenuation_distance_m =
        std::max(static_cast<float>(distance), std::numeric_limits<float>::min());
  }
}

void read_specular(const MaterialPart& extension, Material& material) {
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

void read_clearcoat(const MaterialPart& extension, Material& material) {
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
  if (extension.values().has("clearcoatNormalTexture")) {
    material.clearcoat_normal_scale = extension.normal_scale("clearcoatNormalTexture");
    material.clearcoat_normal_texture =
        extension.texture("clearcoatNormalTexture", Encoding::linear);
  }
}

void read_sheen(const MaterialPart& extension, Material& material) {
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

/// KHR_materials_pbrSpecularGlossiness, but for the alpha mode: a dielectric that reflects the
/// specular colour at normal incidence, which is exact (KHR_materials_specular's colour may exceed
/// 1), over the diffuse one. Its roughness is 1 - glossiness, in 8 bits for a texture. The
/// extension scales the diffuse colour by 1 - the largest specular component; this renderer's
/// dielectric subtracts its reflectance at each angle.
void read_specular_glossiness(const MaterialPart& extension, Material& material) {
  /// Reflectance of a dielectric of index 1.5 at normal incidence.
  constexpr float default_reflectance = 0.04F;
  material.base_color = extension.color("diffuseFactor", 1.0);
  material.alpha = extension.alpha("diffuseFactor");
  material.base_color_texture = extension.texture("diffuseTexture", base_color_encoding(material));
  material.metallic = 0.0F;
  material.specular_color = extension.color("specularFactor", 1.0) / default_reflectance;
  material.specular_color_texture = extension.texture("specularGlossinessTexture", Encoding::srgb);
  const float glossiness = extension.factor("glossinessFactor", 1.0);
  material.metallic_roughness_texture = extension.context().use_glossiness(
      extension.values().object("specularGlossinessTexture"), glossiness);
  material.roughness = material.metallic_roughness_texture.exists() ? 1.0F : 1.0F - glossiness;
}

/// An unlit material has only a base colour (KHR_materials_unlit). Specular and glossiness replace
/// the metallic-roughness values. A texture with factor 0 is not used.
Material read_material(const MaterialPart& source) {
  const GltfValues& values = source.values();
  Material material;
  material.name = values.text("name");
  material.double_sided = values.boolean("doubleSided", false);
  material.unlit = values.extension("KHR_materials_unlit").exists();
  material.alpha_mode = alpha_mode_of(values.text("alphaMode"));
  material.alpha_cutoff = static_cast<float>(values.number("alphaCutoff", 0.5));
  const MaterialPart pbr = source.object("pbrMetallicRoughness");
  const MaterialPart glossy = source.extension("KHR_materials_pbrSpecularGlossiness");
  if (material.unlit) {
    read_base_color(pbr, material);
    return material;
  }
  if (!glossy.values().exists()) {
    read_base_color(pbr, material);
    read_metallic_roughness(pbr, material);
  }
  read_normal_texture(source, material);
  read_emission(source, material);
  read_ior(source.extension("KHR_materials_ior"), material);
  read_transmission(source.extension("KHR_materials_transmission"), material);
  read_volume(source.extension("KHR_materials_volume"), material);
  read_specular(source.extension("KHR_materials_specular"), material);
  read_clearcoat(source.extension("KHR_materials_clearcoat"), material);
  read_sheen(source.extension("KHR_materials_sheen"), material);
  if (glossy.values().exists()) {  // without KHR_materials_specular beside it
    read_specular_glossiness(glossy, material);
  }
  return material;
}

/// Specification, section 5.19: a primitive without a material has the default values of all.
Material default_material() {
  Material material;
  material.name = "default";
  material.metallic = 1.0F;
  return material;
}

bool needs_default_material(const GltfModel& model) {
  const auto has_none = [](const GltfPrimitive& primitive) { return primitive.material < 0; };
  return std::ranges::any_of(model.meshes, [&](const GltfMesh& mesh) {
    return std::ranges::any_of(mesh.primitives, has_none);
  });
}

VertexNeeds needs_of(const Material& material, const std::vector<int>& uv_sets) {
  VertexNeeds needs{.uv_sets = uv_sets, .normal_texture = std::nullopt};
  for (const TextureUse* use : {&material.normal_texture, &material.clearcoat_normal_texture}) {
    if (!needs.normal_texture && use->exists()) {
      needs.normal_texture = *use;
    }
  }
  return needs;
}

}  // namespace

GltfMaterials read_materials(const GltfFile& file, const std::vector<bool>& is_shown,
                             KeptParts<Texels>* kept, bool is_strict, Warnings& warnings) {
  const GltfModel& model = file.model;
  GltfMaterials result;
  TextureSet textures(file, kept, is_strict, warnings);
  for (std::size_t i = 0; i < is_shown.size(); ++i) {
    MaterialContext context(fmt::format("materials[{}]", i), is_shown[i] ? &textures : nullptr,
                            warnings);
    result.materials.push_back(
        read_material(MaterialPart(model.root().item("materials", i), "", context)));
    result.needs.push_back(needs_of(result.materials.back(), context.uv_sets()));
  }
  if (needs_default_material(model)) {
    result.materials.push_back(default_material());
    result.needs.emplace_back();
  }
  result.textures = textures.decode(result.materials);
  result.image_hashes = textures.image_hashes();
  result.missing_files = textures.missing_files();
  return result;
}

}  // namespace foveola
