#include "renderer/scene/prepare/rebase.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

Scene triangle_at(const Vec3& place) {
  Scene scene;
  scene.meshes.resize(1);
  scene.meshes[0].positions = {place, place + Vec3(2, 0, 0), place + Vec3(0, 2, 2)};
  scene.meshes[0].triangles = {{0, 1, 2}};
  scene.cameras = {{.name = "", .position = place, .heading = {}}};
  return scene;
}

TEST(Rebase, ScenesNearTheOriginStay) {
  Scene scene = triangle_at(Vec3(5, -3, 2));
  rebase(scene);
  EXPECT_EQ(scene.origin, DVec3(0.0));
  EXPECT_EQ(scene.meshes[0].positions[0], Vec3(5, -3, 2));
}

TEST(Rebase, FarScenesMoveToTheirMiddleWithoutLosingABit) {
  const Vec3 place(20000.125F, -40000.5F, 100000.75F);
  Scene scene = triangle_at(place);
  scene.instances = {{.name = "", .prototype = 0, .world_from_local = Mat4(1.0F)}};
  scene.instances[0].world_from_local[3] = Vec4(place, 1.0F);
  scene.prototypes = {scene.meshes[0]};
  scene.prototypes[0].positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Scene before = scene;
  rebase(scene);
  EXPECT_GT(glm::length(scene.origin), 1e5);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(glm::length(scene.meshes[0].positions[i]), 8.0F);
    EXPECT_EQ(DVec3(scene.meshes[0].positions[i]) + scene.origin,
              DVec3(before.meshes[0].positions[i]));
  }
  EXPECT_EQ(DVec3(scene.cameras[0].position) + scene.origin, DVec3(place));
  EXPECT_EQ(DVec3(Vec3(scene.instances[0].world_from_local[3])) + scene.origin, DVec3(place));
}

TEST(Rebase, EmptyAndFlatlyInfiniteScenesStay) {
  EXPECT_EQ(origin_for(DVec3(1e9), DVec3(1e9)), DVec3(0.0));
  EXPECT_EQ(origin_for(DVec3(-INFINITY), DVec3(INFINITY)), DVec3(0.0));
}

}  // namespace
}  // namespace foveola
