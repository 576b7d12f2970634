#include "renderer/stability/glb_file.h"

#include <gtest/gtest.h>

#include "renderer/stability/furnished_room.h"
#include "renderer/stability/shapes.h"

namespace foveola {
namespace {

TEST(GlbFileTest, SceneComesBackAsItWas) {
  Scene scene = furnished_room();
  scene.materials.push_back(glass(0.25F));
  scene.meshes.front().material = static_cast<int>(scene.materials.size()) - 1;
  const Scene loaded = through_gltf(scene, room_viewpoint, DVec3(0.0));
  ASSERT_EQ(loaded.object_count(), scene.meshes.size());
  EXPECT_EQ(loaded.triangle_count(), scene.triangle_count());
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    EXPECT_EQ(loaded.meshes[i].positions, scene.meshes[i].positions);
    EXPECT_EQ(loaded.meshes[i].triangles, scene.meshes[i].triangles);
    const Material& before = scene.materials[static_cast<std::size_t>(scene.meshes[i].material)];
    const Material& after = loaded.materials[static_cast<std::size_t>(loaded.meshes[i].material)];
    EXPECT_EQ(after.base_color, before.base_color);
    EXPECT_EQ(after.metallic, before.metallic);
    EXPECT_EQ(after.roughness, before.roughness);
    EXPECT_NEAR(glm::length(after.emission - before.emission), 0.0F, 1e-5F);
    EXPECT_EQ(after.specular, before.specular);
    EXPECT_EQ(after.transmission, before.transmission);
    EXPECT_EQ(after.is_solid, before.is_solid);
  }
  ASSERT_EQ(loaded.cameras.size(), 1U);
  EXPECT_EQ(loaded.cameras.front().position, room_viewpoint);
}

TEST(GlbFileTest, NodeMovesEverything) {
  const DVec3 far(1e7, -2e6, 3e6);
  const Scene loaded = through_gltf(furnished_room(), room_viewpoint, far);
  const Bounds bounds = loaded.bounds();
  const DVec3 middle = 0.5 * (DVec3(bounds.lower) + DVec3(bounds.upper)) + loaded.origin;
  EXPECT_LT(glm::length(middle - far), 1.0);
  const DVec3 camera = DVec3(loaded.cameras.front().position) + loaded.origin;
  EXPECT_LT(glm::length(camera - far - DVec3(room_viewpoint)), 1e-3);
}

}  // namespace
}  // namespace foveola
