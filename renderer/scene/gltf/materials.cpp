#include "renderer/scene/gltf/materials.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/scene/gltf/material_context.h"
#include "renderer/scene/gltf/material_extensions.h"
#include "renderer/scene/gltf/specular_glossiness.h"
#include "renderer/scene/gltf/textures.h"

namespace foveola {
namespace {

/// info: a tinygltf::TextureInfo or tinygltf::NormalTextureInfo.
template <typename Info>
TextureReference reference_to(const Info& info) {
  const auto transform = info.extensions.find("KHR_texture_transform");
  return {.index = info.index,
          .tex_coord = info.texCoord,
          .transform = transform == info.extensions.end() ? nullptr : &transform->second};
}

AlphaMode alpha_mode_of(const tinygltf::Material& source) {
  if (source.alphaMode == "BLEND") {
    return AlphaMode::blend;
  }
  return source.alphaMode == "MASK" ? AlphaMode::mask : AlphaMode::opaque;
}

void read_base_color(const tinygltf::Material& source, MaterialContext& context,
                     Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  const std::vector<double>& factor = pbr.baseColorFactor;
  const std::string place = "pbrMetallicRoughness.baseColorFactor";
  material.base_color = context.limited(DVec3(factor[0], factor[1], factor[2]), 0.0, 1.0, place);
  material.alpha = context.limited(factor[3], 0.0, 1.0, place);
  const bool is_black = max_component(material.base_color) == 0.0F;
  if (!is_black || material.alpha_mode != AlphaMode::opaque) {
    material.base_color_texture =
        context.use(reference_to(pbr.baseColorTexture), base_color_encoding(material));
  }
}

void read_metallic_roughness(const tinygltf::Material& source, MaterialContext& context,
                             Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  material.metallic =
      context.limited(pbr.metallicFactor, 0.0, 1.0, "pbrMetallicRoughness.metallicFactor");
  material.roughness =
      context.limited(pbr.roughnessFactor, 0.0, 1.0, "pbrMetallicRoughness.roughnessFactor");
  if (material.metallic > 0.0F || material.roughness > 0.0F) {
    material.metallic_roughness_texture =
        context.use(reference_to(pbr.metallicRoughnessTexture), Encoding::linear);
  }
}

void read_normal_texture(const tinygltf::Material& source, MaterialContext& context,
                         Material& material) {
  if (source.normalTexture.index < 0) {
    return;
  }
  material.normal_scale = context.limited(source.normalTexture.scale, -steepest_normal_scale,
                                          steepest_normal_scale, "normalTexture.scale");
  if (material.normal_scale != 0.0F) {
    material.normal_texture = context.use(reference_to(source.normalTexture), Encoding::linear);
  }
}

void read_emission(const tinygltf::Material& source, MaterialContext& context, Material& material) {
  material.emission = emission_of(source, context);
  if (material.is_emissive()) {
    material.emissive_texture = context.use(reference_to(source.emissiveTexture), Encoding::srgb);
  }
}

/// Of an unlit material only the base colour counts (KHR_materials_unlit).
Material read_material(const tinygltf::Material& source, MaterialContext& context) {
  Material material;
  material.name = source.name;
  material.double_sided = source.doubleSided;
  material.unlit = source.extensions.contains("KHR_materials_unlit");
  material.alpha_mode = alpha_mode_of(source);
  material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
  const bool is_specular_glossiness = has_specular_glossiness(source) && !material.unlit;
  if (!is_specular_glossiness) {
    read_base_color(source, context, material);
  }
  if (!material.unlit) {
    if (!is_specular_glossiness) {
      read_metallic_roughness(source, context, material);
    }
    read_normal_texture(source, context, material);
    read_emission(source, context, material);
    read_material_extensions(source, context, material);
  }
  if (is_specular_glossiness) {  // it has no KHR_materials_specular beside it
    read_specular_glossiness(source, context, material);
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

bool needs_default_material(const tinygltf::Model& model) {
  const auto has_none = [](const tinygltf::Primitive& primitive) { return primitive.material < 0; };
  return std::any_of(model.meshes.begin(), model.meshes.end(), [&](const tinygltf::Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(), has_none);
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
  const tinygltf::Model& model = *file.model;
  GltfMaterials result;
  TextureSet textures(file, kept, is_strict, warnings);
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    MaterialContext context(fmt::format("materials[{}]", i), is_shown[i] ? &textures : nullptr,
                            warnings);
    result.materials.push_back(read_material(model.materials[i], context));
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
