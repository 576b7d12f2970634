#include "renderer/stability/glb_file.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/base/files.h"
#include "renderer/scene/load_scene.h"

namespace foveola {
namespace {

using Json = nlohmann::json;

std::string bytes_of(const void* data, std::size_t size) {
  return {static_cast<const char*>(data), size};
}

std::string word(std::size_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return bytes_of(&bits, sizeof(bits));
}

Json json_of(const Vec3& v) { return {v.x, v.y, v.z}; }

Json material_json(const Material& material) {
  const float strength = std::max(1.0F, max_component(material.emission));
  Json extensions = {{"KHR_materials_specular", {{"specularFactor", material.specular}}},
                     {"KHR_materials_emissive_strength", {{"emissiveStrength", strength}}}};
  if (material.transmission > 0.0F) {
    extensions["KHR_materials_transmission"] = {{"transmissionFactor", material.transmission}};
  }
  if (material.is_solid) {
    extensions["KHR_materials_volume"] = {{"thicknessFactor", 1.0}};
  }
  Json base_color = json_of(material.base_color);
  base_color.push_back(1.0);
  return {{"pbrMetallicRoughness",
           {{"baseColorFactor", base_color},
            {"metallicFactor", material.metallic},
            {"roughnessFactor", material.roughness}}},
          {"emissiveFactor", json_of(material.emission / strength)},
          {"doubleSided", material.double_sided},
          {"extensions", extensions}};
}

/// glTF 2.0, sections 3.6 and 4.4.
class GlbWriter {
 public:
  GlbWriter() {
    document_ = {{"asset", {{"version", "2.0"}}},
                 {"extensionsUsed",
                  {"KHR_materials_specular", "KHR_materials_emissive_strength",
                   "KHR_materials_transmission", "KHR_materials_volume"}},
                 {"scene", 0}};
  }

  void add_material(const Material& material) {
    document_["materials"].push_back(material_json(material));
  }

  void add_mesh(const Mesh& mesh, const DVec3& translation_m) {
    constexpr int float_component = 5126;
    constexpr int unsigned_component = 5125;
    Json primitive = {{"material", mesh.material}};
    primitive["attributes"]["POSITION"] = add_accessor(mesh.positions, float_component, "VEC3", 1);
    if (!mesh.normals.empty()) {
      primitive["attributes"]["NORMAL"] = add_accessor(mesh.normals, float_component, "VEC3", 1);
    }
    primitive["indices"] = add_accessor(mesh.triangles, unsigned_component, "SCALAR", 3);
    const std::size_t index = add("meshes", {{"primitives", Json::array({primitive})}});
    add_node({{"mesh", index}}, translation_m);
  }

  void add_camera(const DVec3& place) {
    const std::size_t index =
        add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
    add_node({{"camera", index}}, place);
  }

  std::string bytes() && {
    document_["buffers"] = {{{"byteLength", buffer_.size()}}};
    std::string json = document_.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t length = 12 + 8 + json.size() + 8 + buffer_.size();
    return "glTF" + word(2) + word(length) + word(json.size()) + "JSON" + json +
           word(buffer_.size()) + std::string("BIN\0", 4) + buffer_;
  }

 private:
  std::size_t add(const char* array, Json item) {
    document_[array].push_back(std::move(item));
    return document_[array].size() - 1;
  }

  void add_node(Json node, const DVec3& translation_m) {
    node["translation"] = {translation_m.x, translation_m.y, translation_m.z};
    document_["scenes"][0]["nodes"].push_back(add("nodes", std::move(node)));
  }

  /// Every element is of 4-byte numbers, so that all offsets are aligned.
  template <typename Element>
  std::size_t add_accessor(const std::vector<Element>& elements, int component, const char* type,
                           std::size_t values_per_element) {
    const std::size_t size = elements.size() * sizeof(Element);
    const std::size_t view =
        add("bufferViews", {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", size}});
    buffer_ += bytes_of(elements.data(), size);
    return add("accessors", {{"bufferView", view},
                             {"componentType", component},
                             {"count", elements.size() * values_per_element},
                             {"type", type}});
  }

  Json document_;
  std::string buffer_;
};

}  // namespace

std::string glb_of(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m) {
  GlbWriter writer;
  for (const Material& material : scene.materials) {
    writer.add_material(material);
  }
  for (const Mesh& mesh : scene.meshes) {
    writer.add_mesh(mesh, translation_m);
  }
  writer.add_camera(DVec3(viewpoint) + translation_m);
  return std::move(writer).bytes();
}

Scene through_gltf(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "scene.glb";
  write_file(file, glb_of(scene, viewpoint, translation_m));
  return load_gltf(file);
}

}  // namespace foveola
