#include <cmath>

#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

/// A disc of `triangles` triangles of radius 1 about +Z, mesh 0, which no node shows yet.
GlbBuilder disc(int triangles) {
  GlbBuilder glb;
  std::vector<Vec3> fan = {{0, 0, 0}};
  for (int i = 0; i <= triangles; ++i) {
    const double angle = 6.0 * i / triangles;
    fan.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  const int positions = glb.add_vectors(fan);
  constexpr int fan_mode = 6;
  glb.add("meshes",
          {{"name", "disc"},
           {"primitives", {{{"attributes", {{"POSITION", positions}}}, {"mode", fan_mode}}}}});
  return glb;
}

using Placing = LoadGltf;

TEST_F(Placing, FewTrianglesAreCopied) {
  GlbBuilder glb = disc(100);
  for (int i = 0; i < 100; ++i) {
    glb.add_root({{"mesh", 0}, {"translation", {3 * i, 0, 0}}});
  }
  const Scene scene = load(glb);
  EXPECT_EQ(scene.meshes.size(), 100U);
  EXPECT_THAT(scene.instances, IsEmpty());
  EXPECT_EQ(scene.triangle_count(), 10000U);
}

TEST_F(Placing, ManyTrianglesAreKeptOnceAndShownByInstances) {
  GlbBuilder glb = disc(30000);
  glb.add_root({{"mesh", 0}, {"name", "first"}});
  glb.add_root({{"mesh", 0}, {"translation", {5, 0, 0}}});
  EXPECT_EQ(load(glb).meshes.size(), 2U) << "30 000 more triangles";
  glb.add_root({{"mesh", 0}, {"scale", {-2, 1, 1}}});
  glb.add_root({{"mesh", 0}, {"name", "last"}});
  const Scene scene = load(glb);
  EXPECT_THAT(scene.meshes, IsEmpty());
  ASSERT_EQ(scene.prototypes.size(), 1U);
  EXPECT_EQ(scene.prototypes[0].name, "disc");
  EXPECT_EQ(scene.prototypes[0].positions[1], Vec3(1, 0, 0));
  ASSERT_EQ(scene.instances.size(), 4U);
  EXPECT_EQ(scene.instances[0].name, "first");
  EXPECT_EQ(scene.instances[1].name, "disc") << "the mesh's, where the node has none";
  EXPECT_EQ(scene.instances[1].world_from_local * Vec4(1, 0, 0, 1), Vec4(6, 0, 0, 1));
  EXPECT_EQ(scene.instances[2].world_from_local * Vec4(1, 0, 0, 1), Vec4(-2, 0, 0, 1));
  EXPECT_EQ(scene.triangle_count(), 120000U);
  EXPECT_EQ(scene.bounds().upper.x, 6.0F);
}

TEST_F(Placing, EveryPrimitiveBecomesAPrototype) {
  GlbBuilder glb = disc(40000);
  Json& primitives = glb.document["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  glb.add("materials", {{"name", "back"}});
  primitives[1]["material"] = 0;
  glb.add_root({{"mesh", 0}});
  glb.add_root({{"mesh", 0}});
  const Scene scene = load(glb);
  ASSERT_EQ(scene.prototypes.size(), 2U);
  EXPECT_EQ(scene.prototypes[0].material, 1);
  EXPECT_EQ(scene.prototypes[1].material, 0);
  ASSERT_EQ(scene.instances.size(), 4U);
  EXPECT_EQ(scene.instances[2].prototype, 0U);
  EXPECT_EQ(scene.instances[3].prototype, 1U);
}

/// An instance needs an inverse: what is flattened is copied instead, as far as it keeps an area.
TEST_F(Placing, FlattenedInstancesAreCopied) {
  GlbBuilder glb = disc(40000);
  glb.add_root({{"mesh", 0}});
  glb.add_root({{"mesh", 0}, {"scale", {1, 1, 0}}});
  glb.add_root({{"mesh", 0}, {"scale", {0, 0, 0}}});
  const Scene scene = load(glb);
  EXPECT_EQ(scene.instances.size(), 1U);
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 40000U);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("leaves without area are dropped (40000 "
                                                    "times")));
}

/// 300 kilobytes of nodes that ask for 4096 x 20 000 triangles, flat, so that all must be copied.
TEST_F(Placing, RefusesCopiesBeyondAllMeasure) {
  GlbBuilder glb = disc(20000);
  for (int i = 0; i < 4096; ++i) {
    glb.add_root({{"mesh", 0}, {"scale", {1, 1, 0}}});
  }
  EXPECT_THAT(
      error_of(glb),
      HasSubstr("meshes[0]: the scene needs more memory than a file of its size may request"));
}

/// 2000 nodes that show 10 000 primitives each.
TEST_F(Placing, RefusesInstancesBeyondAllMeasure) {
  GlbBuilder glb = disc(20);
  Json& primitives = glb.document["meshes"][0]["primitives"];
  const Json primitive = primitives[0];
  for (int i = 1; i < 10000; ++i) {
    primitives.push_back(primitive);
  }
  for (int i = 0; i < 2000; ++i) {
    glb.add_root({{"mesh", 0}});
  }
  EXPECT_THAT(error_of(glb), HasSubstr("meshes[0]: the scene needs more memory"));
}

/// In floats 1e7 + 0.25 is 1e7; seen from the new origin nothing is lost.
TEST_F(Placing, FarScenesAreSeenFromNearby) {
  GlbBuilder glb = one_triangle();
  glb.document["nodes"][0]["translation"] = {1e7 + 0.25, -2e7, 0.125};
  glb.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  glb.add_root({{"camera", 0}, {"translation", {1e7 + 0.75, -2e7 + 0.5, 1.0}}});
  glb.add_light({{"type", "point"}}, {{"translation", {1e7 - 0.25, -2e7, 2.0}}});
  const Scene scene = load(glb);
  const DVec3 local(scene.meshes.at(0).positions[0]);
  EXPECT_EQ(scene.origin + local, DVec3(1e7 + 0.25, -2e7, 0.125));
  EXPECT_EQ(scene.origin + DVec3(scene.cameras.at(0).position), DVec3(1e7 + 0.75, -2e7 + 0.5, 1.0));
  EXPECT_EQ(scene.origin + DVec3(scene.lights.at(0).position), DVec3(1e7 - 0.25, -2e7, 2.0));
  EXPECT_LT(glm::length(local), 2.0) << "about the scene's centre";
}

TEST_F(Placing, InstancesOfFarScenesAreSeenFromNearby) {
  GlbBuilder glb = disc(40000);
  glb.add_root({{"mesh", 0}, {"translation", {1e7 + 0.25, 0, 0}}});
  glb.add_root({{"mesh", 0}, {"translation", {1e7 + 2.5, 0, 0}}});
  glb.add_root({{"mesh", 0}, {"translation", {1e7 - 3, 0, 0}}});
  const Scene scene = load(glb);
  ASSERT_EQ(scene.instances.size(), 3U);
  EXPECT_EQ(scene.origin + DVec3(scene.instances[0].world_from_local[3]), DVec3(1e7 + 0.25, 0, 0));
}

/// The same scene of another size 1e5 of its sizes away: only the scale differs, to the last bit.
TEST_F(Placing, TheChoiceOfOriginHasNoScale) {
  const auto placed = [&](double size) {
    GlbBuilder glb = one_triangle();
    glb.add("nodes", {{"mesh", 0}, {"scale", {size, size, size}}});
    glb.document["nodes"][0] = {{"translation", {1e5 * size, 0, 0}}, {"children", {1}}};
    return load(glb);
  };
  const Scene unit = placed(1.0);
  const Scene large = placed(1024.0);
  const Scene small = placed(1.0 / 1024.0);
  EXPECT_EQ(large.origin, 1024.0 * unit.origin);
  EXPECT_EQ(small.origin, unit.origin / 1024.0);
  EXPECT_EQ(large.meshes.at(0).positions[1], 1024.0F * unit.meshes.at(0).positions[1]);
}

}  // namespace
}  // namespace foveola::test
