#include "renderer/progressive/proposed_objects.h"

#include "renderer/stability/shapes.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

Mesh box(const std::string& name, const Vec3& center, float half, int material = 0) {
  Mesh mesh = inside_out(inward_box(center, half, material));
  mesh.name = name;
  return mesh;
}

/// All around the origin, from which it is looked at.
Mesh walls() {
  Mesh mesh = inward_box(Vec3(0.0F), 10.0F, 0);
  mesh.name = "walls";
  return mesh;
}

std::vector<ProposedObject> proposed_in(std::vector<Mesh> meshes, const ProposalRule& rule = {},
                                        const Workers& workers = Workers(2)) {
  Scene scene;
  scene.meshes = std::move(meshes);
  scene.materials = {matte(Rgb(0.5F)), lamp(Rgb(1.0F))};
  const LoadedScene loaded({.name = "test"}, std::move(scene), workers,
                           {.camera = DVec3(0.0), .head = AzimuthElevation{}});
  return propose_objects(loaded, workers, rule);
}

std::vector<std::string> names_of(const std::vector<ProposedObject>& proposed) {
  std::vector<std::string> names;
  for (const ProposedObject& object : proposed) {
    names.push_back(object.object.name);
  }
  return names;
}

TEST(ProposedObjects, SayWhereTheyAreAndHowLarge) {
  const std::vector<ProposedObject> proposed =
      proposed_in({walls(), box("crate", {0.0F, 0.0F, -5.0F}, 0.5F)});
  ASSERT_THAT(names_of(proposed), ElementsAre("crate"));
  const ProposedObject& crate = proposed[0];
  EXPECT_NEAR(crate.object.position.x, 0.0F, 0.05F);
  EXPECT_NEAR(crate.object.position.y, 0.0F, 0.05F);
  EXPECT_NEAR(crate.object.position.z, -4.5F, 1e-4F);
  // Its face's corners lie atan(sqrt(0.5) / 4.5) from the middle; 98 of 100 points are nearer.
  EXPECT_LT(crate.object.radius_deg, 8.93F);
  EXPECT_GT(crate.object.radius_deg, 7.9F);
  EXPECT_EQ(crate.visible_share, 1.0);
  EXPECT_NEAR(crate.distance_m, 4.5, 0.01);
}

/// The lower half of the crate's face is behind a wall that is nearer by one metre; the crate's
/// other faces are seen by no ray.
TEST(ProposedObjects, SayWhatShareOfThemIsVisible) {
  Mesh screen = box("screen", {0.0F, -2.0F, -3.5F}, 2.0F);
  for (Vec3& corner : screen.positions) {
    corner.z = -3.5F + 0.01F * (corner.z + 3.5F);
  }
  const std::vector<ProposedObject> proposed = proposed_in(
      {walls(), screen, box("crate", {0.0F, 0.0F, -5.0F}, 0.5F)}, {.least_visible_share = 0.4});
  ASSERT_THAT(names_of(proposed), ElementsAre("crate"));
  EXPECT_NEAR(proposed[0].visible_share, 0.5, 0.02);
  EXPECT_GT(proposed[0].object.position.y, 0.1F);
  EXPECT_THAT(proposed_in({walls(), screen, box("crate", {0.0F, 0.0F, -5.0F}, 0.5F)},
                          {.least_visible_share = 0.6}),
              IsEmpty());
}

TEST(ProposedObjects, AreNeitherTinyNorHugeNorOverhead) {
  EXPECT_THAT(proposed_in({walls(), box("tiny", {0.0F, 0.0F, -5.0F}, 0.03F),
                           box("huge", {0.0F, 0.0F, 5.0F}, 2.0F),
                           box("overhead", {0.0F, 5.0F, 0.5F}, 0.5F)}),
              IsEmpty());
}

TEST(ProposedObjects, DoNotShine) {
  EXPECT_THAT(names_of(proposed_in({walls(), box("lamp", {0.0F, 0.0F, -5.0F}, 0.5F, 1),
                                    box("crate", {0.0F, 0.0F, 5.0F}, 0.5F)})),
              ElementsAre("crate"));
}

TEST(ProposedObjects, FillTheirCircle) {
  Mesh cable = box("cable", {0.0F, 0.0F, -5.0F}, 1.0F);
  for (Vec3& corner : cable.positions) {
    corner.y *= 0.02F;
  }
  EXPECT_THAT(proposed_in({walls(), cable}), IsEmpty());
}

TEST(ProposedObjects, LieApart) {
  EXPECT_THAT(names_of(proposed_in({walls(), box("large", {0.0F, 0.0F, -5.0F}, 0.6F),
                                    box("small, before it", {0.2F, 0.1F, -3.0F}, 0.06F),
                                    box("beside it", {2.5F, 0.0F, -5.0F}, 0.6F)},
                                   {.least_visible_share = 0.2})),
              UnorderedElementsAre("large", "beside it"));
}

TEST(ProposedObjects, AreSeveralMeshesOfOneName) {
  const std::vector<ProposedObject> proposed =
      proposed_in({walls(), box("chair", {0.0F, 0.25F, -5.0F}, 0.25F),
                   box("chair", {0.0F, -0.25F, -5.0F}, 0.25F)});
  ASSERT_THAT(names_of(proposed), ElementsAre("chair"));
  EXPECT_GT(proposed[0].object.radius_deg, 5.0F);
}

TEST(ProposedObjects, WithoutANameAreNumbered) {
  EXPECT_THAT(names_of(proposed_in({walls(), box("", {0.0F, 0.0F, -5.0F}, 0.5F)})),
              ElementsAre("object 2"));
  EXPECT_THAT(names_of(proposed_in({walls(), box("", {0.0F, 0.0F, -5.0F}, 0.5F),
                                    box("object 2", {0.0F, 0.0F, 5.0F}, 0.5F)})),
              UnorderedElementsAre("another object 2", "object 2"));
}

TEST(ProposedObjects, AreTheBestFirstAndNotTooMany) {
  std::vector<Mesh> meshes{walls()};
  for (int i = 0; i < 8; ++i) {
    const float azimuth = 0.75F * static_cast<float>(i);
    meshes.push_back(box("box " + std::to_string(i),
                         {5.0F * std::sin(azimuth), 0.0F, -5.0F * std::cos(azimuth)},
                         0.1F + 0.02F * static_cast<float>(i)));
  }
  const std::vector<std::string> names = names_of(proposed_in(meshes, {.max_objects = 3}));
  EXPECT_THAT(names, SizeIs(3));
  EXPECT_THAT(names, Not(Contains("box 0")));
}

TEST(ProposedObjects, AreTheSameOnAnyNumberOfThreads) {
  const std::vector<Mesh> meshes{walls(), box("a", {0.0F, 0.0F, -5.0F}, 0.5F),
                                 box("b", {5.0F, 0.0F, 0.0F}, 0.4F)};
  const std::vector<ProposedObject> one = proposed_in(meshes, {}, Workers(1));
  const std::vector<ProposedObject> four = proposed_in(meshes, {}, Workers(4));
  ASSERT_EQ(names_of(one), names_of(four));
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].object.position, four[i].object.position);
    EXPECT_EQ(one[i].object.radius_deg, four[i].object.radius_deg);
  }
}

TEST(ProposedObjects, AreNoneOfAnEmptyScene) { EXPECT_THAT(proposed_in({}), IsEmpty()); }

}  // namespace
}  // namespace foveola::test
