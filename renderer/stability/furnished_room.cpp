#include "renderer/stability/furnished_room.h"

#include <utility>

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

Scene baked(Scene scene, float scale, const Vec3& place) {
  for (Mesh& mesh : scene.meshes) {
    mesh = placed(std::move(mesh), scale, Quat(1, 0, 0, 0), place);
  }
  rebase(scene);
  return scene;
}

}  // namespace foveola
