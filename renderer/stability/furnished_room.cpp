#include "renderer/stability/furnished_room.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/files/files.h"
#include "renderer/base/numbers/random.h"
#include "renderer/glb/glb_document.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/prepare/rebase.h"
#include "renderer/stability/shapes.h"

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

Scene furnished_room() {
  enum : int { white, red, green, blue, shining, steel };
  Scene scene;
  scene.materials = {matte(Rgb(0.75F)),
                     matte(Rgb(0.7F, 0.2F, 0.2F)),
                     matte(Rgb(0.2F, 0.6F, 0.2F)),
                     matte(Rgb(0.2F, 0.3F, 0.8F)),
                     lamp(Rgb(6.0F, 5.0F, 4.0F)),
                     metal(0.9F, 0.4F)};
  const auto wall = [&](const Vec3& corner, const Vec3& a, const Vec3& b, int material) {
    scene.meshes.push_back(tessellated_quad(corner, a, b, 4, material));
  };
  wall({-1, -1, 1}, {2, 0, 0}, {0, 0, -2}, white);
  wall({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, white);
  wall({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, blue);
  wall({1, -1, 1}, {-2, 0, 0}, {0, 2, 0}, white);
  wall({-1, -1, 1}, {0, 0, -2}, {0, 2, 0}, red);
  wall({1, -1, -1}, {0, 0, 2}, {0, 2, 0}, green);
  scene.meshes.push_back(quad({-0.5F, 0.98F, -0.5F}, {1, 0, 0}, {0, 0, 1}, shining));

  const Quat tilted = glm::angleAxis(0.6F, glm::normalize(Vec3(1, 2, 0.5F)));
  const Quat level(1, 0, 0, 0);
  scene.meshes.push_back(placed(inside_out(inward_box(Vec3(0.0F), 0.25F, white)), 1.0F, tilted,
                                {-0.45F, -0.5F, -0.5F}));
  scene.meshes.push_back(
      placed(inside_out(inward_sphere(0.3F, 4, red)), 1.0F, level, {0.5F, -0.6F, -0.4F}));
  scene.meshes.push_back(placed(torus(0.35F, 0.12F, 48, steel), 1.0F, tilted, {0.2F, -0.3F, 0.6F}));
  return scene;
}

namespace {

/// Glass with a tint per tenth of a metre.
Material tinted_glass() {
  Material material = glass();
  material.attenuation_color = Rgb(0.3F, 0.7F, 0.9F);
  material.attenuation_distance_m = 0.1F;
  return material;
}

Material thin_pane() {
  Material material = glass();
  material.is_solid = false;
  material.base_color = Rgb(0.9F, 0.95F, 0.9F);
  return material;
}

Material covered() {
  Material material = dielectric(0.5F, 0.5F);
  material.clearcoat = 0.8F;
  material.clearcoat_roughness = 0.1F;
  material.sheen_color = Rgb(0.2F);
  material.sheen_roughness = 0.4F;
  return material;
}

Material half_there() {
  Material material = matte(Rgb(0.8F, 0.6F, 0.2F));
  material.alpha = 0.5F;
  material.alpha_mode = AlphaMode::blend;
  return material;
}

/// Its base colour is the scene's first texture, its roughness and normals the second.
Material papered() {
  Material material = dielectric(1.0F);
  material.base_color_texture.texture = 0;
  material.metallic_roughness_texture.texture = 1;
  material.normal_texture.texture = 1;
  return material;
}

/// 8 x 8 texels between the two given ones.
Texture pattern(const std::array<std::uint8_t, 4>& from, const std::array<std::uint8_t, 4>& to) {
  constexpr std::uint32_t side = 8;
  std::vector<std::uint8_t> texels;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t share = mix(i) & 255U;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      texels.push_back(
          static_cast<std::uint8_t>((from[channel] * (255U - share) + to[channel] * share) / 255U));
    }
  }
  return {side, side, texels, false, Wrap::repeat, Wrap::mirrored_repeat};
}

Mesh papered_quad(const Vec3& corner, const Vec3& a, const Vec3& b, int material) {
  Mesh mesh = quad(corner, a, b, material);
  mesh.uv_sets = {{{0, 0}, {3, 0}, {3, 3}, {0, 3}}};
  mesh.tangents.assign(mesh.positions.size(), Vec4(glm::normalize(a), 1.0F));
  return mesh;
}

}  // namespace

Scene room_of_everything() {
  Scene scene = furnished_room();
  const auto add = [&](const Material& material) {
    scene.materials.push_back(material);
    return static_cast<int>(scene.materials.size()) - 1;
  };
  scene.textures = {pattern({220, 60, 20, 255}, {40, 200, 90, 255}),
                    pattern({110, 120, 250, 255}, {150, 140, 200, 255})};
  // A wall gives way to a window.
  scene.meshes[5] = quad({1, -1, -1}, {0, 0, 2}, {0, 2, 0}, add(thin_pane()));
  scene.environment = constant_environment(0.5F);
  scene.meshes.push_back(
      papered_quad({-0.9F, -0.99F, 0.9F}, {1.2F, 0, 0}, {0, 0, -1.2F}, add(papered())));
  scene.meshes.push_back(quad({-0.2F, -0.6F, 0.4F}, {0.4F, 0, 0}, {0, 0.5F, 0}, add(half_there())));
  const Quat level(1, 0, 0, 0);
  const auto ball = [&](float radius, const Vec3& place, const Material& material) {
    scene.meshes.push_back(
        placed(inside_out(inward_sphere(radius, 3, add(material))), 1.0F, level, place));
  };
  ball(0.2F, {-0.5F, 0.2F, -0.4F}, tinted_glass());
  ball(0.03F, {-0.5F, 0.2F, -0.4F}, lamp(Rgb(20.0F)));
  ball(0.15F, {0.0F, 0.3F, -0.6F}, glass(0.3F));
  ball(0.15F, {0.4F, 0.2F, -0.6F}, metal(1.0F, 0.0F));
  scene.prototypes = {torus(0.15F, 0.05F, 24, add(covered()))};
  Mat4 standing = glm::translate(Mat4(1.0F), Vec3(-0.6F, -0.7F, 0.3F));
  Mat4 mirrored = glm::scale(glm::translate(Mat4(1.0F), Vec3(0.7F, 0.6F, 0.2F)), Vec3(-1, 1.5F, 1));
  scene.instances = {{.prototype = 0, .world_from_local = standing},
                     {.prototype = 0, .world_from_local = mirrored}};
  scene.lights = {{.position = Vec3(0.5F, 0.5F, 0.5F), .intensity = Rgb(0.3F)},
                  {.position = Vec3(-0.5F, 0.6F, 0.5F), .intensity = Rgb(0.2F), .radius_m = 0.05F},
                  {.kind = PunctualLight::Kind::directional,
                   .direction = glm::normalize(Vec3(-1.0F, -0.4F, 0.1F)),
                   .intensity = Rgb(2.0F),
                   .angular_radius_rad = 0.01F}};
  return scene;
}

Scene baked(Scene scene, float scale, const Vec3& place) {
  for (Mesh& mesh : scene.meshes) {
    mesh = placed(std::move(mesh), scale, Quat(1, 0, 0, 0), place);
  }
  rebase(scene);
  return scene;
}

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
