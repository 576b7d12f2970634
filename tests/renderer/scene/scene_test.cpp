#include "renderer/scene/scene.h"

#include <cstdint>
#include <random>

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

/// Instances of a tetrahedron and of nothing, turned, mirrored and stretched, among each other and
/// far out: each vertex of each, one after the other, is the bounds' definition.
TEST(Scene, BoundsAreThoseOfTheVerticesOfAllInstances) {
  std::mt19937 random(7);  // NOLINT: the same each time
  std::uniform_real_distribution<float> any(-1.0F, 1.0F);
  for (int trial = 0; trial < 50; ++trial) {
    Scene scene;
    scene.meshes.resize(2);
    scene.meshes[0].positions = {{0, 0, 0}, {0.1F, any(random), 0}};
    scene.prototypes.resize(2);
    for (int vertex = 0; vertex < 4; ++vertex) {
      scene.prototypes[0].positions.emplace_back(any(random), any(random), any(random));
    }
    for (std::uint32_t i = 0; i < 100; ++i) {
      Instance& instance = scene.instances.emplace_back();
      instance.prototype = i % 10 == 0 ? 1 : 0;
      for (int column = 0; column < 4; ++column) {
        const float scale = column == 3 && i % 20 == 1 ? 50.0F : 1.0F;
        instance.world_from_local[column] =
            Vec4(scale * Vec3(any(random), any(random), any(random)), column == 3 ? 1.0F : 0.0F);
      }
    }
    Vec3 lower(1e9F);
    Vec3 upper(-1e9F);
    for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
      for (const Vec3& position : scene.mesh_of(object).positions) {
        lower = glm::min(lower, scene.in_world(object, position));
        upper = glm::max(upper, scene.in_world(object, position));
      }
    }
    EXPECT_EQ(scene.bounds().lower, lower);
    EXPECT_EQ(scene.bounds().upper, upper);
  }
}

TEST(Scene, AnEmptyOneHasZeroBounds) {
  EXPECT_EQ(Scene{}.triangle_count(), 0U);
  EXPECT_EQ(Scene{}.bounds().lower, Vec3(0.0F));
  EXPECT_EQ(Scene{}.bounds().upper, Vec3(0.0F));
}

}  // namespace
}  // namespace foveola
