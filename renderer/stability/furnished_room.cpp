#include "renderer/stability/furnished_room.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/random.h"
#include "renderer/scene/rebase.h"
#include "renderer/stability/shapes.h"

namespace foveola {

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

/// Glass that tints what goes a tenth of a metre through it.
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

}  // namespace foveola
