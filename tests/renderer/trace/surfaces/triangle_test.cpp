#include "renderer/trace/surfaces/triangle.h"

#include <gtest/gtest.h>

#include "renderer/trace/rays/mesh_attributes.h"
#include "tests/renderer/trace/scenes.h"

namespace foveola {
namespace {

TEST(TriangleTest, NormalAndAreaAreRightAtAnySize) {
  const Vec3 expected = glm::normalize(Vec3(2, -1, 3));
  const Vec3 a = glm::normalize(glm::cross(expected, Vec3(0, 1, 0)));
  const Vec3 b = glm::cross(expected, a);
  for (const float size : {1e-15F, 1e-6F, 1.0F, 1e6F, 1e15F}) {
    const Mesh mesh = quad(Vec3(0.0F), size * a, size * b, 0);
    const Triangle triangle(mesh, 0);
    EXPECT_NEAR(glm::length(triangle.front_normal() - expected), 0.0, 1e-6) << size;
    EXPECT_NEAR(triangle.area() / (0.5 * size * size), 1.0, 1e-6) << size;
  }
}

TEST(TriangleTest, InterpolatesBetweenItsCorners) {
  const Mesh mesh = quad(Vec3(1, 2, 3), Vec3(4, 0, 0), Vec3(0, 0, 8), 0);
  EXPECT_EQ(Triangle(mesh, 0).at({0.5F, 0.25F}), Vec3(4, 2, 5));
  EXPECT_EQ(interpolate(mesh.uv_sets[0], mesh.triangles[0], {0.5F, 0.25F}), Vec2(0.75F, 0.25F));
}

// A mirror turns the corners' order around; the front must stay the front (glTF 2.0, 3.7.4).
TEST(TriangleTest, FrontOfAMirroredInstanceFollowsItsSurface) {
  Scene scene;
  scene.materials.resize(1);
  scene.prototypes = {quad(Vec3(0.0F), Vec3(1, 0, 0), Vec3(0, 0, -1), 0)};  // faces +y
  Mat4 world_from_local(1.0F);
  world_from_local[0].x = -2.0F;
  scene.instances = {{.name = "", .prototype = 0, .world_from_local = world_from_local}};
  EXPECT_EQ(Triangle(scene, 0, 0).front_normal(), Vec3(0, 1, 0));
  EXPECT_NEAR(Triangle(scene, 0, 0).area(), 1.0, 1e-6);
  scene.instances[0].world_from_local[0].x = 1.0F;
  scene.instances[0].world_from_local[1].y = -1.0F;
  EXPECT_EQ(Triangle(scene, 0, 0).front_normal(), Vec3(0, -1, 0));
}

}  // namespace
}  // namespace foveola
