#include "renderer/stability/glb_file.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/files.h"
#include "renderer/glb/glb_document.h"
#include "renderer/scene/load_scene.h"

namespace foveola {
namespace {

using Json = nlohmann::json;
using Glb = GlbDocument<Json>;

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

void add_node(Glb& glb, Json node, const DVec3& translation_m) {
  node["translation"] = {translation_m.x, translation_m.y, translation_m.z};
  glb.add_root(std::move(node));
}

template <typename Element>
int add_accessor(Glb& glb, const std::vector<Element>& elements, GlbComponent component,
                 const char* type, std::size_t values_per_element) {
  return glb.add_accessor(std::as_bytes(std::span(elements)), component, type,
                          elements.size() * values_per_element);
}

void add_mesh(Glb& glb, const Mesh& mesh, const DVec3& translation_m) {
  Json primitive = {{"material", mesh.material}};
  primitive["attributes"]["POSITION"] =
      add_accessor(glb, mesh.positions, GlbComponent::float32, "VEC3", 1);
  if (!mesh.normals.empty()) {
    primitive["attributes"]["NORMAL"] =
        add_accessor(glb, mesh.normals, GlbComponent::float32, "VEC3", 1);
  }
  primitive["indices"] = add_accessor(glb, mesh.triangles, GlbComponent::uint32, "SCALAR", 3);
  const int index = glb.add("meshes", {{"primitives", Json::array({primitive})}});
  add_node(glb, {{"mesh", index}}, translation_m);
}

void add_camera(Glb& glb, const DVec3& place) {
  const int index = glb.add(
      "cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  add_node(glb, {{"camera", index}}, place);
}

}  // namespace

std::string glb_of(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m) {
  Glb glb;
  glb.document = {{"asset", {{"version", "2.0"}}},
                  {"extensionsUsed",
                   {"KHR_materials_specular", "KHR_materials_emissive_strength",
                    "KHR_materials_transmission", "KHR_materials_volume"}},
                  {"scene", 0}};
  for (const Material& material : scene.materials) {
    glb.add("materials", material_json(material));
  }
  for (const Mesh& mesh : scene.meshes) {
    add_mesh(glb, mesh, translation_m);
  }
  add_camera(glb, DVec3(viewpoint) + translation_m);
  return glb.bytes();
}

Scene through_gltf(const Scene& scene, const Vec3& viewpoint, const DVec3& translation_m) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "scene.glb";
  write_file(file, glb_of(scene, viewpoint, translation_m));
  return load_gltf(file);
}

}  // namespace foveola
