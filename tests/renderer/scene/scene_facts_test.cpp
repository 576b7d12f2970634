#include "renderer/scene/scene_facts.h"

#include <memory>

#include "tests/matchers.h"

namespace foveola {
namespace {

Mesh triangle(int material) {
  Mesh mesh;
  mesh.material = material;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// A triangle that shines, one that hangs in three places, and a material that nothing has.
Scene small_scene() {
  Scene scene;
  scene.materials.resize(3);
  scene.materials[0].emission = Rgb(1.0F);
  scene.materials[1].clearcoat = 0.5F;
  scene.materials[2].unlit = true;
  scene.meshes = {triangle(0)};
  scene.prototypes = {triangle(1)};
  scene.instances.resize(3);
  return scene;
}

TEST(SceneFacts, CountsInstancesAsSeenAndTheirMeshOnce) {
  const SceneFacts facts = facts_of(small_scene());
  EXPECT_EQ(facts.objects, 4U);
  EXPECT_EQ(facts.instances, 3U);
  EXPECT_EQ(facts.triangles, 4U);
  EXPECT_EQ(facts.stored_triangles, 2U);
  EXPECT_EQ(facts.emissive_triangles, 1U);
  EXPECT_EQ(facts.bounds.upper, Vec3(1, 2, 0));
}

/// Three vertices of three floats and a triangle of three indices, twice.
TEST(SceneFacts, CountsTheBytesOfItsArrays) {
  Scene scene = small_scene();
  EXPECT_EQ(facts_of(scene).geometry_bytes, 2U * (3 * 12 + 12));
  scene.meshes[0].uv_sets = {{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_EQ(facts_of(scene).geometry_bytes, 2U * (3 * 12 + 12) + 3 * 8);
}

TEST(SceneFacts, CountsSharedTexelsOnce) {
  const auto texels = std::make_shared<const Texels>(
      DecodedImage{
          .width = 64, .height = 64, .channels = 1, .texels = std::vector<std::uint8_t>(64 * 64)},
      true, false);
  Scene scene = small_scene();
  scene.textures = {Texture(texels, {}), Texture(texels, {.wrap_u = Wrap::clamp_to_edge})};
  EXPECT_EQ(facts_of(scene).textures, 2U);
  EXPECT_EQ(facts_of(scene).texture_bytes, texels->memory_bytes() + 2 * sizeof(Texture));
}

TEST(SceneFacts, NamesWhatUsedMaterialsNeed) {
  const SceneFacts facts = facts_of(small_scene());
  EXPECT_THAT(facts.features, Contains("emission"));
  EXPECT_THAT(facts.features, Contains("clearcoat"));
  EXPECT_THAT(facts.features, Contains("instances"));
  EXPECT_THAT(facts.features, Not(Contains("unlit"))) << "no triangle has that material";
  EXPECT_THAT(facts.absent_features, Contains("unlit"));
  EXPECT_THAT(facts.absent_features, Contains("textures"));
}

TEST(SceneFacts, AnEmptySceneHasNone) {
  const SceneFacts facts = facts_of(Scene());
  EXPECT_EQ(facts.triangles, 0U);
  EXPECT_EQ(facts.geometry_bytes, 0U);
  EXPECT_THAT(facts.features, IsEmpty());
}

Scene dark_scene() {
  Scene scene = small_scene();
  scene.materials[0].emission = Rgb(0.0F);
  return scene;
}

TEST(HasLight, FindsWhatShines) {
  EXPECT_FALSE(has_light(dark_scene())) << "nothing has the unlit material";
  EXPECT_TRUE(has_light(small_scene()));
  Scene unlit = dark_scene();
  unlit.prototypes[0].material = 2;
  EXPECT_TRUE(has_light(unlit));
  Scene lamp = dark_scene();
  lamp.lights.resize(1);
  EXPECT_TRUE(has_light(lamp));
  lamp.lights[0].intensity = Rgb(0.0F);
  EXPECT_FALSE(has_light(lamp));
  Scene outdoors = dark_scene();
  outdoors.environment.emplace();
  EXPECT_TRUE(has_light(outdoors));
  outdoors.environment->radiance = Rgb(0.0F);
  EXPECT_FALSE(has_light(outdoors));
}

TEST(HasLight, ALampIsNotSeenWhereThereAreNoSurfaces) {
  Scene scene;
  scene.lights.resize(1);
  EXPECT_FALSE(has_light(scene));
  scene.environment.emplace();
  EXPECT_TRUE(has_light(scene));
}

}  // namespace
}  // namespace foveola
