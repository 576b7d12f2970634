#include <cmath>

#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

using GltfDeformation = LoadGltf;

/// Targets that lift the second corner by 2 and the third by 4.
GlbBuilder morphed() {
  GlbBuilder glb = one_triangle();
  glb.primitive()["targets"] = {{{"POSITION", glb.add_vectors({{0, 0, 0}, {0, 0, 2}, {0, 0, 0}})}},
                                {{"POSITION", glb.add_vectors({{0, 0, 0}, {0, 0, 0}, {0, 0, 4}})}}};
  return glb;
}

TEST_F(GltfDeformation, MorphsByTheMeshsWeights) {
  GlbBuilder glb = morphed();
  EXPECT_THAT(load(glb).meshes.at(0).positions,
              ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
  glb.document["meshes"][0]["weights"] = {0.5, 0.25};
  const Scene scene = load(glb);
  EXPECT_THAT(scene.meshes.at(0).positions,
              ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(0, 1, 1)));
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(GltfDeformation, ANodesWeightsAreItsOwn) {
  GlbBuilder glb = morphed();
  glb.add_root({{"mesh", 0}, {"weights", {1.0, 0.0}}});
  glb.add_root({{"mesh", 0}, {"weights", {0.0, 1.0}}, {"translation", {5, 0, 0}}});
  const Scene scene = load(glb);
  ASSERT_EQ(scene.meshes.size(), 3U);
  EXPECT_THAT(scene.meshes[0].positions, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
  EXPECT_THAT(scene.meshes[1].positions, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 2), Vec3(0, 1, 0)));
  EXPECT_THAT(scene.meshes[2].positions, ElementsAre(Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(5, 1, 4)));
}

TEST_F(GltfDeformation, MorphsNormals) {
  GlbBuilder glb = one_triangle();
  glb.primitive()["attributes"]["NORMAL"] = glb.add_vectors({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  glb.primitive()["targets"] = {
      {{"NORMAL", glb.add_vectors({{3, 0, 3}, {3, 0, 3}, {3, 0, 3}})}, {"TEXCOORD_0", 0}}};
  glb.document["meshes"][0]["weights"] = {1};
  const Scene scene = load(glb);
  EXPECT_NEAR(scene.meshes.at(0).normals.at(0).x, 0.6F, 1e-6F);
  EXPECT_NEAR(scene.meshes.at(0).normals.at(0).z, 0.8F, 1e-6F);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("positions, normals and tangents only")));
}

/// The triangle's first two corners hang on joint 1, the third half on each; the mesh's own node
/// stands elsewhere, which does not count.
GlbBuilder skinned() {
  GlbBuilder glb = one_triangle();
  glb.document["nodes"][0]["translation"] = {100, 0, 0};
  const int bones = glb.add_root({{"translation", {0, 0, 1}}});
  const int bone = glb.add("nodes", {{"translation", {2, 0, 0}}});
  glb.document["nodes"][bones]["children"] = {bone};
  const int joints =
      glb.add_accessor<std::uint8_t>({1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, uint8, "VEC4", 4);
  const int weights =
      glb.add_accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0}, float32, "VEC4", 4);
  glb.primitive()["attributes"]["JOINTS_0"] = joints;
  glb.primitive()["attributes"]["WEIGHTS_0"] = weights;
  glb.add("skins", {{"joints", {bones, bone}}});
  glb.document["nodes"][0]["skin"] = 0;
  return glb;
}

TEST_F(GltfDeformation, SkinsStandWhereTheirJointsDo) {
  const Scene scene = load(skinned());
  EXPECT_THAT(scene.meshes.at(0).positions,
              ElementsAre(Vec3(2, 0, 1), Vec3(3, 0, 1), Vec3(1, 1, 1)));
  EXPECT_THAT(scene.warnings, IsEmpty());
}

/// Where the joints still are as the mesh was bound to them, it keeps its shape.
TEST_F(GltfDeformation, InverseBindMatricesComeFirst) {
  GlbBuilder glb = skinned();
  const std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, -1, 1,
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -2, 0, -1, 1};
  glb.document["skins"][0]["inverseBindMatrices"] = glb.add_accessor(matrices, float32, "MAT4", 16);
  EXPECT_THAT(load(glb).meshes.at(0).positions,
              ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
}

/// A joint twice as wide along x: a normal (3, 0, 4) / 5 becomes (3/2, 0, 4) over its length.
TEST_F(GltfDeformation, SkinsTurnNormals) {
  GlbBuilder glb = skinned();
  glb.document["nodes"][1]["scale"] = {2, 1, 1};
  glb.primitive()["attributes"]["NORMAL"] =
      glb.add_vectors({{0.6F, 0, 0.8F}, {0.6F, 0, 0.8F}, {0.6F, 0, 0.8F}});
  const Scene scene = load(glb);
  const float length = std::hypot(1.5F, 4.0F);
  for (const Vec3& normal : scene.meshes.at(0).normals) {
    EXPECT_NEAR(normal.x, 1.5F / length, 1e-6F);
    EXPECT_NEAR(normal.z, 4.0F / length, 1e-6F);
  }
}

TEST_F(GltfDeformation, ASkinWithoutJointsInItsMeshIsIgnored) {
  GlbBuilder glb = skinned();
  glb.primitive()["attributes"].erase("WEIGHTS_0");
  const Scene scene = load(glb);
  EXPECT_EQ(scene.from_file({100, 0, 0}), scene.meshes.at(0).positions.at(0));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("a skin is ignored")));
}

TEST_F(GltfDeformation, RefusesWhatIsNotThere) {
  GlbBuilder few = skinned();
  few.document["skins"][0]["joints"] = {1};
  EXPECT_THAT(error_of(few), HasSubstr("attributes.JOINTS_0: names joint 1, but the skin has 1"));

  GlbBuilder matrices = skinned();
  matrices.document["skins"][0]["inverseBindMatrices"] =
      matrices.add_accessor(std::vector<float>(16, 0.0F), float32, "MAT4", 16);
  EXPECT_THAT(error_of(matrices),
              HasSubstr("skins[0].inverseBindMatrices: has 1 matrices for 2 joints"));

  GlbBuilder target = morphed();
  target.document["meshes"][0]["weights"] = {1};
  target.document["accessors"][1]["count"] = 2;
  EXPECT_THAT(error_of(target),
              HasSubstr("targets[0].POSITION: accessors[1] has 2 elements, but POSITION has 3"));
}

}  // namespace
}  // namespace foveola::test
