#include "renderer/scene/scene.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

TEST(Scene, CountsTrianglesAndBoundsVerticesOfAllMeshes) {
  Scene scene;
  scene.meshes.resize(2);
  scene.meshes[0].positions = {{1, 2, 3}, {-1, 5, 3}};
  scene.meshes[0].triangles.resize(4);
  scene.meshes[1].positions = {{0, 0, 9}};
  scene.meshes[1].triangles.resize(3);
  EXPECT_EQ(scene.triangle_count(), 7U);
  EXPECT_EQ(scene.bounds().lower, Vec3(-1, 0, 3));
  EXPECT_EQ(scene.bounds().upper, Vec3(1, 5, 9));
}

TEST(Scene, AnEmptyOneHasZeroBounds) {
  EXPECT_EQ(Scene{}.triangle_count(), 0U);
  EXPECT_EQ(Scene{}.bounds().lower, Vec3(0.0F));
  EXPECT_EQ(Scene{}.bounds().upper, Vec3(0.0F));
}

}  // namespace
}  // namespace foveola
