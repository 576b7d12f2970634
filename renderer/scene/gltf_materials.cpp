#include "renderer/scene/gltf_materials.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/scene/gltf_textures.h"

namespace foveola {
namespace {

constexpr const char* strength_extension = "KHR_materials_emissive_strength";

Vec3 vector_of(const std::vector<double>& numbers) {
  return {static_cast<float>(numbers[0]), static_cast<float>(numbers[1]),
          static_cast<float>(numbers[2])};
}

/// `value` in [lowest, highest], with a warning if it was not.
template <typename T>
T limited(const T& value, float lowest, float highest, const char* what, const std::string& place,
          Warnings& warnings) {
  const T result = glm::clamp(value, T(lowest), T(highest));
  if (result != value) {
    warnings.add(fmt::format("{} is limited to the range it may have", what), place);
  }
  return result;
}

float emissive_strength(const tinygltf::Material& source) {
  const auto extension = source.extensions.find(strength_extension);
  if (extension == source.extensions.end() || !extension->second.Has("emissiveStrength")) {
    return 1.0F;
  }
  return static_cast<float>(extension->second.Get("emissiveStrength").GetNumberAsDouble());
}

Rgb emission_of(const tinygltf::Material& source, const std::string& place, Warnings& warnings) {
  constexpr float brightest = 1e9F;
  return limited(vector_of(source.emissiveFactor) * emissive_strength(source), 0.0F, brightest,
                 "the emission of a material", place, warnings);
}

AlphaMode alpha_mode_of(const tinygltf::Material& source) {
  if (source.alphaMode == "BLEND") {
    return AlphaMode::blend;
  }
  return source.alphaMode == "MASK" ? AlphaMode::mask : AlphaMode::opaque;
}

/// The set that the base colour names, else that of the first texture there is: a mesh keeps one.
std::optional<int> uv_set_of(const tinygltf::Material& source, const Material& material,
                             const std::string& place, Warnings& warnings) {
  struct Use {
    int texture;
    int uv_set;
  };
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  const std::array<Use, 3> uses = {
      {{material.base_color_texture.texture, pbr.baseColorTexture.texCoord},
       {material.metallic_roughness_texture.texture, pbr.metallicRoughnessTexture.texCoord},
       {material.emissive_texture.texture, source.emissiveTexture.texCoord}}};
  std::optional<int> chosen;
  for (const Use& use : uses) {
    if (use.texture < 0) {
      continue;
    }
    if (chosen && *chosen != use.uv_set) {
      warnings.add("a material's textures all use the texture coordinates of the first", place);
    }
    chosen = chosen.value_or(use.uv_set);
  }
  return chosen;
}

Material read_material(const tinygltf::Material& source, const std::string& place,
                       TextureSet& textures, Warnings& warnings) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  const std::string pbr_place = place + ".pbrMetallicRoughness";
  Material material;
  material.name = source.name;
  material.base_color = limited(vector_of(pbr.baseColorFactor), 0.0F, 1.0F, "a base colour",
                                pbr_place + ".baseColorFactor", warnings);
  material.alpha = limited(static_cast<float>(pbr.baseColorFactor[3]), 0.0F, 1.0F, "an alpha",
                           pbr_place + ".baseColorFactor", warnings);
  material.metallic = limited(static_cast<float>(pbr.metallicFactor), 0.0F, 1.0F,
                              "a metallic factor", pbr_place + ".metallicFactor", warnings);
  material.roughness = limited(static_cast<float>(pbr.roughnessFactor), 0.0F, 1.0F,
                               "a roughness factor", pbr_place + ".roughnessFactor", warnings);
  material.emission = emission_of(source, place, warnings);
  material.double_sided = source.doubleSided;
  material.base_color_texture.texture = textures.add(pbr.baseColorTexture.index, Encoding::srgb);
  material.metallic_roughness_texture.texture =
      textures.add(pbr.metallicRoughnessTexture.index, Encoding::linear);
  if (material.is_emissive()) {
    material.emissive_texture.texture = textures.add(source.emissiveTexture.index, Encoding::srgb);
  }
  material.alpha_mode = alpha_mode_of(source);
  material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
  if (source.normalTexture.index >= 0) {
    warnings.add("normal textures are ignored", place + ".normalTexture");
  }
  return material;
}

/// Specification, section 5.19: a primitive without a material has the default values of all.
tinygltf::Material default_material() {
  tinygltf::Material material;
  material.name = "default";
  material.emissiveFactor = {0.0, 0.0, 0.0};
  return material;
}

bool needs_default_material(const tinygltf::Model& model) {
  const auto has_none = [](const tinygltf::Primitive& primitive) { return primitive.material < 0; };
  return std::any_of(model.meshes.begin(), model.meshes.end(), [&](const tinygltf::Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(), has_none);
  });
}

}  // namespace

GltfMaterials read_materials(const tinygltf::Model& model, Warnings& warnings) {
  GltfMaterials result;
  TextureSet textures(model);
  const auto append = [&](const tinygltf::Material& source, const std::string& place) {
    result.materials.push_back(read_material(source, place, textures, warnings));
    result.uv_sets.push_back(uv_set_of(source, result.materials.back(), place, warnings));
  };
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    append(model.materials[i], fmt::format("materials[{}]", i));
  }
  if (needs_default_material(model)) {
    append(default_material(), "materials");
  }
  result.textures = textures.decode();
  return result;
}

}  // namespace foveola
