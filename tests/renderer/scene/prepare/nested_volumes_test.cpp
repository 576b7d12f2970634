#include "renderer/scene/prepare/nested_volumes.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

Material glass() {
  Material material;
  material.transmission = 1.0F;
  material.is_solid = true;
  return material;
}

/// A tetrahedron of this size around a point, of the material of this number.
Mesh tetrahedron(const std::string& name, const Vec3& center, float size, int material = 0) {
  return {.name = name,
          .material = material,
          .positions = {center + Vec3(size, size, size), center + Vec3(size, -size, -size),
                        center + Vec3(-size, size, -size), center + Vec3(-size, -size, size)},
          .triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

TEST(NestedVolumes, AreWarnedOf) {
  Scene scene{.materials = {glass()}};
  scene.meshes = {tetrahedron("water", Vec3(0.0F), 0.9F), tetrahedron("tumbler", Vec3(0.0F), 1.0F)};
  const std::string warning =
      "water may lie within tumbler, and both refract light: at its surface light is refracted as "
      "if it stood in air";
  EXPECT_EQ(warning_of_nested_volumes(scene), warning);
  std::swap(scene.meshes[0], scene.meshes[1]);
  EXPECT_EQ(warning_of_nested_volumes(scene), warning);
}

TEST(NestedVolumes, MayBeInstances) {
  Scene scene{.materials = {glass()}};
  scene.meshes = {tetrahedron("tumbler", Vec3(5.0F, 0.0F, 0.0F), 1.0F)};
  scene.prototypes = {tetrahedron("", Vec3(0.0F), 0.9F)};
  scene.instances = {{.name = "ice", .prototype = 0}};
  EXPECT_FALSE(warning_of_nested_volumes(scene)) << "5 m away";
  scene.instances[0].world_from_local[3] = Vec4(5.0F, 0.0F, 0.0F, 1.0F);
  EXPECT_TRUE(warning_of_nested_volumes(scene));
}

TEST(NestedVolumes, AreOfRefractingMaterialBoth) {
  Scene scene{.materials = {glass(), Material()}};
  scene.meshes = {tetrahedron("stone", Vec3(0.0F), 0.9F, 1),
                  tetrahedron("tumbler", Vec3(0.0F), 1.0F)};
  EXPECT_FALSE(warning_of_nested_volumes(scene));
}

TEST(NestedVolumes, OfAMillionEndInTime) {
  Scene scene{.materials = {glass()}};
  scene.prototypes = {tetrahedron("", Vec3(0.0F), 1.0F)};
  scene.instances.resize(1'000'000);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {  // beside each other, not within
    scene.instances[i].world_from_local[3] = Vec4(0.0F, 0.001F * static_cast<float>(i), 0.0F, 1.0F);
  }
  EXPECT_FALSE(warning_of_nested_volumes(scene));
}

}  // namespace
}  // namespace foveola
