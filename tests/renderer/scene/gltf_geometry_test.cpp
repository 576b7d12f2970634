#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int points_mode = 0;
constexpr int strip_mode = 5;
constexpr int fan_mode = 6;

using Corners = std::array<std::uint32_t, 3>;

/// The normal of the front face of triangle `i`: counter-clockwise corners turn around it.
Vec3 front_normal(const Mesh& mesh, std::size_t i = 0) {
  const Corners& corners = mesh.triangles.at(i);
  const Vec3 a = mesh.positions[corners[0]];
  return glm::normalize(glm::cross(mesh.positions[corners[1]] - a, mesh.positions[corners[2]] - a));
}

void expect_near(const Vec3& actual, const Vec3& expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-5F);
  EXPECT_NEAR(actual.y, expected.y, 1e-5F);
  EXPECT_NEAR(actual.z, expected.z, 1e-5F);
}

/// Four corners of a square in the order of a strip: lower left, lower right, upper left, upper
/// right.
const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};

Json& primitive(GlbBuilder& glb) { return glb.document["meshes"][0]["primitives"][0]; }

GlbBuilder unindexed(const std::vector<Vec3>& positions, int mode) {
  GlbBuilder glb;
  const int accessor = glb.add_vectors(positions);
  glb.add_root(
      {{"mesh", glb.add_mesh({{"attributes", {{"POSITION", accessor}}}, {"mode", mode}})}});
  return glb;
}

template <typename Index>
GlbBuilder indexed(const std::vector<Index>& indices, ComponentType type, int mode = 4) {
  GlbBuilder glb = unindexed(square, mode);
  primitive(glb)["indices"] = glb.add_accessor(indices, type, "SCALAR", 1);
  return glb;
}

using Geometry = LoadGltf;

TEST_F(Geometry, StripsTurnEverySecondTriangle) {
  const Mesh mesh = load(unindexed(square, strip_mode)).meshes.at(0);
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}, Corners{1, 3, 2}));
  expect_near(front_normal(mesh, 0), {0, 0, 1});
  expect_near(front_normal(mesh, 1), {0, 0, 1});
}

TEST_F(Geometry, FansShareTheirFirstVertex) {
  const Mesh mesh =
      load(unindexed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, fan_mode)).meshes.at(0);
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{1, 2, 0}, Corners{2, 3, 0}));
  expect_near(front_normal(mesh, 0), {0, 0, 1});
  expect_near(front_normal(mesh, 1), {0, 0, 1});
}

TEST_F(Geometry, EveryIndexTypeNamesTheSameVertices) {
  const auto expected = ElementsAre(Corners{0, 1, 3}, Corners{0, 3, 2});
  EXPECT_THAT(load(indexed<std::uint8_t>({0, 1, 3, 0, 3, 2}, u8)).meshes.at(0).triangles, expected);
  EXPECT_THAT(load(indexed<std::uint16_t>({0, 1, 3, 0, 3, 2}, u16)).meshes.at(0).triangles,
              expected);
  EXPECT_THAT(load(indexed<std::uint32_t>({0, 1, 3, 0, 3, 2}, u32)).meshes.at(0).triangles,
              expected);
}

TEST_F(Geometry, StripsAndFansMayBeIndexed) {
  EXPECT_THAT(load(indexed<std::uint8_t>({1, 3, 0, 2}, u8, strip_mode)).meshes.at(0).triangles,
              ElementsAre(Corners{1, 3, 0}, Corners{3, 2, 0}));
  EXPECT_THAT(load(indexed<std::uint8_t>({0, 1, 3, 2}, u8, fan_mode)).meshes.at(0).triangles,
              ElementsAre(Corners{1, 3, 0}, Corners{3, 2, 0}));
}

TEST_F(Geometry, KeepsOnlyTheVerticesThatAreUsed) {
  GlbBuilder glb = indexed<std::uint8_t>({1, 3, 2}, u8);
  glb.buffer.append(4, '\0');
  const Mesh mesh = load(glb).meshes.at(0);
  EXPECT_THAT(mesh.positions, ElementsAre(square[1], square[2], square[3]));
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 2, 1}));
}

TEST_F(Geometry, NegativeScaleKeepsFrontFacesInFront) {
  GlbBuilder glb = one_triangle();
  const int normals = glb.add_vectors({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  primitive(glb)["attributes"]["NORMAL"] = normals;
  glb.document["nodes"][0]["scale"] = {-1, 1, 1};
  const Mesh mesh = load(glb).meshes.at(0);
  expect_near(front_normal(mesh), {0, 0, 1});
  expect_near(mesh.normals[0], {0, 0, 1});
  EXPECT_EQ(mesh.positions[1], Vec3(-1, 0, 0));
}

TEST_F(Geometry, TwoMirrorsAreNone) {
  GlbBuilder glb = one_triangle();
  glb.document["nodes"][0]["scale"] = {-1, -1, 1};
  const Mesh mesh = load(glb).meshes.at(0);
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}));
  expect_near(front_normal(mesh), {0, 0, 1});
}

/// A plane through the axes at 45 degrees, squeezed to half along X: its normal is (2, 1, 0)/sqrt
/// 5, where its tangent is (0.5, -1, 0).
TEST_F(Geometry, NormalsStayPerpendicularUnderUnevenScale) {
  for (const double z : {1.0, -3.0}) {
    GlbBuilder glb;
    const int positions = glb.add_vectors({{1, 0, 0}, {0, 1, 0}, {1, 0, 1}});
    const int normals = glb.add_vectors(std::vector<Vec3>(3, glm::normalize(Vec3(1, 1, 0))));
    const int mesh = glb.add_mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
    glb.add_root({{"mesh", mesh}, {"scale", {0.5, 1, z}}});
    expect_near(load(glb).meshes.at(0).normals[0], Vec3(2, 1, 0) / std::sqrt(5.0F));
  }
}

TEST_F(Geometry, MissingNormalsStayMissing) {
  EXPECT_THAT(load(one_triangle()).meshes.at(0).normals, IsEmpty());
}

TEST_F(Geometry, UnusableNormalsBecomeTheSurfacesOwn) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  GlbBuilder glb = one_triangle();
  primitive(glb)["attributes"]["NORMAL"] =
      glb.add_vectors({{nan, 0, 0}, {0, 0, 0}, {0, 0.6F, 0.8F}});
  const Scene scene = load(glb);
  const Mesh& mesh = scene.meshes.at(0);
  expect_near(mesh.normals[0], {0, 0, 1});
  expect_near(mesh.normals[1], {0, 0, 1});
  expect_near(mesh.normals[2], {0, 0.6F, 0.8F});
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("normals of no use are replaced by those of the "
                                    "surface (2 times, first at "
                                    "meshes[0].primitives[0])")));
}

TEST_F(Geometry, NormalsHaveUnitLength) {
  GlbBuilder glb = one_triangle();
  primitive(glb)["attributes"]["NORMAL"] = glb.add_vectors({{0, 0, 7}, {0, 3, 4}, {0, 0, 0.01F}});
  glb.document["nodes"][0]["scale"] = {100, 100, 100};
  const Mesh mesh = load(glb).meshes.at(0);
  expect_near(mesh.normals[0], {0, 0, 1});
  expect_near(mesh.normals[1], {0, 0.6F, 0.8F});
  expect_near(mesh.normals[2], {0, 0, 1});
}

TEST_F(Geometry, DropsTrianglesWithoutAreaAndCountsThem) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Scene scene = load(unindexed({{0, 0, 0},
                                      {1, 0, 0},
                                      {2, 0, 0},  // on a line
                                      {5, 5, 5},
                                      {5, 5, 5},
                                      {6, 5, 5},  // two corners
                                      {nan, 0, 0},
                                      {1, 0, 0},
                                      {0, 1, 0},  // not a number
                                      {infinity, 0, 0},
                                      {1, 0, 0},
                                      {0, 1, 0},  // not finite
                                      {0, 0, 3},
                                      {1, 0, 3},
                                      {0, 1, 3}},  // good
                                     4));
  ASSERT_EQ(scene.triangle_count(), 1U);
  EXPECT_THAT(scene.meshes[0].positions, ElementsAre(Vec3(0, 0, 3), Vec3(1, 0, 3), Vec3(0, 1, 3)));
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("are dropped (4 times, first at "
                                                 "meshes[0].primitives[0])")));
  EXPECT_EQ(scene.bounds().upper, Vec3(1, 1, 3));
}

TEST_F(Geometry, WithoutAnyTriangleTheSceneSaysSo) {
  const Scene scene = load(unindexed({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 4));
  EXPECT_TRUE(scene.meshes.empty());
  EXPECT_THAT(scene.warnings, Contains("the scene has no triangles"));
  EXPECT_EQ(scene.bounds().lower, Vec3(0.0F));
}

TEST_F(Geometry, PointsAreSkippedWithAWarning) {
  GlbBuilder glb = one_triangle();
  glb.document["meshes"][0]["primitives"].push_back(
      {{"attributes", {{"POSITION", 0}}}, {"mode", points_mode}});
  const Scene scene = load(glb);
  EXPECT_EQ(scene.triangle_count(), 1U);
  EXPECT_THAT(scene.warnings, ElementsAre("points and lines are not shown "
                                          "(meshes[0].primitives[1])"));
}

TEST_F(Geometry, WarnsOfColoursAndMorphTargets) {
  GlbBuilder glb = one_triangle();
  primitive(glb)["attributes"]["COLOR_0"] = 0;
  primitive(glb)["targets"] = {{{"POSITION", 0}}};
  EXPECT_THAT(load(glb).warnings, ElementsAre(HasSubstr("vertex colours are ignored"),
                                              HasSubstr("morph targets are ignored")));
}

TEST_F(Geometry, RefusesAnIndexBeyondTheVertices) {
  EXPECT_THAT(error_of(indexed<std::uint8_t>({0, 1, 4}, u8)),
              HasSubstr("meshes[0].primitives[0].indices: names vertex 4, but POSITION has 4"));
}

TEST_F(Geometry, RefusesAttributesOfDifferentCounts) {
  GlbBuilder glb = one_triangle();
  primitive(glb)["attributes"]["NORMAL"] = glb.add_vectors({{0, 0, 1}, {0, 0, 1}});
  EXPECT_THAT(error_of(glb),
              HasSubstr("meshes[0].primitives[0].attributes.NORMAL: accessors[1] has "
                        "2 elements, but POSITION has 3"));
}

/// 300 bytes of JSON that ask for 4096 x 20000 triangles.
TEST_F(Geometry, RefusesInstancesBeyondAllMeasure) {
  GlbBuilder glb;
  std::vector<Vec3> fan = {{0, 0, 0}};
  for (int i = 0; i < 20001; ++i) {
    fan.emplace_back(std::cos(0.0001F * static_cast<float>(i)),
                     std::sin(0.0001F * static_cast<float>(i)), 0.0F);
  }
  const int positions = glb.add_vectors(fan);
  glb.add_mesh({{"attributes", {{"POSITION", positions}}}, {"mode", fan_mode}});
  for (int i = 0; i < 4096; ++i) {
    glb.add_root({{"mesh", 0}});
  }
  EXPECT_THAT(error_of(glb), HasSubstr("meshes[0].primitives[0]: brings the scene, with every "
                                       "instance copied, to more than 67108864 triangles"));
}

}  // namespace
}  // namespace foveola::test
