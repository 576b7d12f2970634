#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

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

/// Four corners of a square in the order of a strip: lower left, lower right, upper left, upper
/// right.
const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};

GlbBuilder unindexed(const std::vector<Vec3>& positions, int mode) {
  GlbBuilder glb;
  const int accessor = glb.add_vectors(positions);
  glb.add_root(
      {{"mesh", glb.add_mesh({{"attributes", {{"POSITION", accessor}}}, {"mode", mode}})}});
  return glb;
}

template <typename Index>
GlbBuilder indexed(const std::vector<Index>& indices, GlbComponent type, int mode = 4) {
  GlbBuilder glb = unindexed(square, mode);
  glb.primitive()["indices"] = glb.add_accessor(indices, type, "SCALAR", 1);
  return glb;
}

using Geometry = LoadGltf;

TEST_F(Geometry, StripsTurnEverySecondTriangle) {
  const Mesh mesh = load(unindexed(square, strip_mode)).meshes.at(0);
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}, Corners{1, 3, 2}));
  expect_vec_near(front_normal(mesh, 0), {0, 0, 1});
  expect_vec_near(front_normal(mesh, 1), {0, 0, 1});
}

TEST_F(Geometry, FansShareTheirFirstVertex) {
  const Mesh mesh =
      load(unindexed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, fan_mode)).meshes.at(0);
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{1, 2, 0}, Corners{2, 3, 0}));
  expect_vec_near(front_normal(mesh, 0), {0, 0, 1});
  expect_vec_near(front_normal(mesh, 1), {0, 0, 1});
}

TEST_F(Geometry, EveryIndexTypeNamesTheSameVertices) {
  const auto expected = ElementsAre(Corners{0, 1, 3}, Corners{0, 3, 2});
  EXPECT_THAT(load(indexed<std::uint8_t>({0, 1, 3, 0, 3, 2}, uint8)).meshes.at(0).triangles,
              expected);
  EXPECT_THAT(load(indexed<std::uint16_t>({0, 1, 3, 0, 3, 2}, uint16)).meshes.at(0).triangles,
              expected);
  EXPECT_THAT(load(indexed<std::uint32_t>({0, 1, 3, 0, 3, 2}, uint32)).meshes.at(0).triangles,
              expected);
}

TEST_F(Geometry, StripsAndFansMayBeIndexed) {
  EXPECT_THAT(load(indexed<std::uint8_t>({1, 3, 0, 2}, uint8, strip_mode)).meshes.at(0).triangles,
              ElementsAre(Corners{1, 3, 0}, Corners{3, 2, 0}));
  EXPECT_THAT(load(indexed<std::uint8_t>({0, 1, 3, 2}, uint8, fan_mode)).meshes.at(0).triangles,
              ElementsAre(Corners{1, 3, 0}, Corners{3, 2, 0}));
}

TEST_F(Geometry, KeepsOnlyTheVerticesThatAreUsed) {
  GlbBuilder glb = indexed<std::uint8_t>({1, 3, 2}, uint8);
  glb.buffer.append(4, '\0');
  const Mesh mesh = load(glb).meshes.at(0);
  EXPECT_THAT(mesh.positions, ElementsAre(square[1], square[2], square[3]));
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 2, 1}));
}

TEST_F(Geometry, NegativeScaleKeepsFrontFacesInFront) {
  GlbBuilder glb = one_triangle();
  const int normals = glb.add_vectors({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  glb.primitive()["attributes"]["NORMAL"] = normals;
  glb.document["nodes"][0]["scale"] = {-1, 1, 1};
  const Mesh mesh = load(glb).meshes.at(0);
  expect_vec_near(front_normal(mesh), {0, 0, 1});
  expect_vec_near(mesh.normals[0], {0, 0, 1});
  EXPECT_EQ(mesh.positions[1], Vec3(-1, 0, 0));
}

TEST_F(Geometry, TwoMirrorsAreNone) {
  GlbBuilder glb = one_triangle();
  glb.document["nodes"][0]["scale"] = {-1, -1, 1};
  const Mesh mesh = load(glb).meshes.at(0);
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}));
  expect_vec_near(front_normal(mesh), {0, 0, 1});
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
    expect_vec_near(load(glb).meshes.at(0).normals[0], Vec3(2, 1, 0) / std::sqrt(5.0F));
  }
}

TEST_F(Geometry, UnusableNormalsBecomeTheSurfacesOwn) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  GlbBuilder glb = one_triangle();
  glb.primitive()["attributes"]["NORMAL"] =
      glb.add_vectors({{nan, 0, 0}, {0, 0, 0}, {0, 0.6F, 0.8F}});
  const Scene scene = load(glb);
  const Mesh& mesh = scene.meshes.at(0);
  expect_vec_near(mesh.normals[0], {0, 0, 1});
  expect_vec_near(mesh.normals[1], {0, 0, 1});
  expect_vec_near(mesh.normals[2], {0, 0.6F, 0.8F});
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("invalid normals are replaced by the surface's (2 times, first "
                                    "at meshes[0].primitives[0])")));
}

TEST_F(Geometry, NormalsHaveUnitLength) {
  GlbBuilder glb = one_triangle();
  glb.primitive()["attributes"]["NORMAL"] = glb.add_vectors({{0, 0, 7}, {0, 3, 4}, {0, 0, 0.01F}});
  glb.document["nodes"][0]["scale"] = {100, 100, 100};
  const Mesh mesh = load(glb).meshes.at(0);
  expect_vec_near(mesh.normals[0], {0, 0, 1});
  expect_vec_near(mesh.normals[1], {0, 0.6F, 0.8F});
  expect_vec_near(mesh.normals[2], {0, 0, 1});
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

TEST_F(Geometry, WarnsOfFurtherColours) {
  GlbBuilder glb = one_triangle();
  glb.primitive()["attributes"]["COLOR_1"] = 0;
  EXPECT_THAT(load(glb).warnings,
              ElementsAre(HasSubstr("vertex colours other than the first are ignored")));
}

TEST_F(Geometry, ReadsColoursOfAllTypes) {
  GlbBuilder glb = one_triangle();
  const auto colors = [&](int accessor) {
    glb.document["accessors"][accessor]["normalized"] =
        glb.document["accessors"][accessor]["componentType"] != static_cast<int>(float32);
    glb.primitive()["attributes"]["COLOR_0"] = accessor;
    return load(glb).meshes.at(0).colors;
  };
  EXPECT_THAT(colors(glb.add_vectors({{0.5F, 0, 1}, {0, 0.25F, 0}, {0, 0, 0}})),
              ElementsAre(Vec4(0.5F, 0, 1, 1), Vec4(0, 0.25F, 0, 1), Vec4(0, 0, 0, 1)));
  EXPECT_THAT(colors(glb.add_accessor<float>({0.5F, 0, 1, 0.75F, 0, 0, 0, 0, 1, 1, 1, 1}, float32,
                                             "VEC4", 4)),
              ElementsAre(Vec4(0.5F, 0, 1, 0.75F), Vec4(0, 0, 0, 0), Vec4(1, 1, 1, 1)));
  EXPECT_THAT(colors(glb.add_accessor<std::uint8_t>({51, 0, 255, 102, 0, 0, 0, 0, 0, 0, 0, 0},
                                                    uint8, "VEC4", 4)),
              ElementsAre(Vec4(0.2F, 0, 1, 0.4F), Vec4(0), Vec4(0)));
  EXPECT_THAT(colors(glb.add_accessor<std::uint16_t>({13107, 0, 65535, 0, 0, 0, 0, 0, 0}, uint16,
                                                     "VEC3", 3)),
              ElementsAre(Vec4(0.2F, 0, 1, 1), Vec4(0, 0, 0, 1), Vec4(0, 0, 0, 1)));
}

TEST_F(Geometry, LimitsColoursWithAWarning) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  GlbBuilder glb = one_triangle();
  glb.primitive()["attributes"]["COLOR_0"] =
      glb.add_vectors({{2, -1, 0.5F}, {nan, 0, 0}, {0.5F, 0.5F, 0.5F}});
  const Scene scene = load(glb);
  EXPECT_THAT(scene.meshes.at(0).colors,
              ElementsAre(Vec4(1, 0, 0.5F, 1), Vec4(1, 0, 0, 1), Vec4(0.5F, 0.5F, 0.5F, 1)));
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("vertex colours are clamped to their range (2 times")));
}

TEST_F(Geometry, WhiteVerticesKeepNoColours) {
  GlbBuilder glb = one_triangle();
  glb.primitive()["attributes"]["COLOR_0"] = glb.add_vectors({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  EXPECT_THAT(load(glb).meshes.at(0).colors, IsEmpty());
}

/// A square seen from +Z with its texture upright and unmirrored: u along +X, v (down the image)
/// along -Y. Material 0 has a normal texture.
GlbBuilder normal_mapped() {
  GlbBuilder glb = indexed<std::uint8_t>({0, 1, 3, 0, 3, 2}, uint8);
  glb.primitive()["attributes"]["NORMAL"] = glb.add_vectors(std::vector<Vec3>(4, {0, 0, 1}));
  glb.primitive()["attributes"]["TEXCOORD_0"] = glb.add_uvs({{0, 1}, {1, 1}, {0, 0}, {1, 0}});
  const int texture = glb.add_texture(one_pixel(128, 128, 255));
  glb.primitive()["material"] = glb.add("materials", {{"normalTexture", {{"index", texture}}}});
  return glb;
}

TEST_F(Geometry, ComputesMissingTangentsOfNormalMappedMeshes) {
  EXPECT_THAT(load(normal_mapped()).meshes.at(0).tangents, Each(::testing::Eq(Vec4(1, 0, 0, 1))));
}

TEST_F(Geometry, ReadsTangentsOnlyWhereANormalTextureNeedsThem) {
  GlbBuilder glb = normal_mapped();
  glb.primitive()["attributes"]["TANGENT"] = glb.add_accessor<float>(
      {0, 2, 0, -1, 0, 2, 0, -1, 0, 2, 0, -1, 0, 2, 0, -1}, float32, "VEC4", 4);
  EXPECT_THAT(load(glb).meshes.at(0).tangents, Each(::testing::Eq(Vec4(0, 1, 0, -1))));
  glb.document["materials"][0] = Json::object();
  EXPECT_THAT(load(glb).meshes.at(0).tangents, IsEmpty());
}

/// As some exporters write them where a texture is stretched over nothing.
TEST_F(Geometry, ZeroTangentsAreComputedAnew) {
  GlbBuilder glb = normal_mapped();
  glb.primitive()["attributes"]["TANGENT"] =
      glb.add_accessor<float>({0, 0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, float32, "VEC4", 4);
  const Scene scene = load(glb);
  EXPECT_THAT(scene.meshes.at(0).tangents, Each(::testing::Eq(Vec4(1, 0, 0, 1))));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("invalid tangents")));
}

/// In a mirror the picture of the texture is mirrored too: sign * cross(normal, tangent) must stay
/// the mirror image of the bitangent, which is +Y here.
TEST_F(Geometry, TangentsFollowTheirNode) {
  GlbBuilder glb = normal_mapped();
  glb.document["nodes"][0]["scale"] = {-2, 3, 1};
  const Mesh mesh = load(glb).meshes.at(0);
  for (const Vec4& tangent : mesh.tangents) {
    EXPECT_EQ(tangent, Vec4(-1, 0, 0, -1));
    EXPECT_EQ(tangent.w * glm::cross(Vec3(0, 0, 1), Vec3(tangent)), Vec3(0, 1, 0));
  }
}

/// Specification, section 3.7.2.1: without normals the mesh is flat and its tangents are ignored.
TEST_F(Geometry, FlatMeshesGetTangentsOfTheirOwn) {
  GlbBuilder glb = normal_mapped();
  glb.primitive()["attributes"].erase("NORMAL");
  glb.primitive()["attributes"]["TANGENT"] =
      glb.add_accessor<float>({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, float32, "VEC4", 4);
  const Mesh mesh = load(glb).meshes.at(0);
  EXPECT_THAT(mesh.normals, IsEmpty());
  EXPECT_THAT(mesh.tangents, Each(::testing::Eq(Vec4(1, 0, 0, 1))));
}

TEST_F(Geometry, MissingFiniteCoordinatesAreZero) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  GlbBuilder glb = normal_mapped();
  glb.primitive()["attributes"]["TEXCOORD_0"] =
      glb.add_uvs({{0, 1}, {infinity, 1}, {0, 0}, {1, 0}});
  const Scene scene = load(glb);
  EXPECT_EQ(scene.meshes.at(0).uv_sets.at(0).at(1), Vec2(0, 0));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("texture coordinates that are not finite")));
}

TEST_F(Geometry, RefusesAnIndexBeyondTheVertices) {
  EXPECT_THAT(error_of(indexed<std::uint8_t>({0, 1, 4}, uint8)),
              HasSubstr("meshes[0].primitives[0].indices: names vertex 4, but POSITION has 4"));
}

TEST_F(Geometry, RefusesAttributesOfDifferentCounts) {
  GlbBuilder glb = one_triangle();
  glb.primitive()["attributes"]["NORMAL"] = glb.add_vectors({{0, 0, 1}, {0, 0, 1}});
  EXPECT_THAT(error_of(glb),
              HasSubstr("meshes[0].primitives[0].attributes.NORMAL: accessors[1] has "
                        "2 elements, but POSITION has 3"));
}

/// A strip of a million triangles in one byte each, which 200 kilobytes of JSON name 2000 times.
TEST_F(Geometry, RefusesPrimitivesBeyondAllMeasure) {
  std::vector<std::uint8_t> strip(1000000);
  for (std::size_t i = 0; i < strip.size(); ++i) {
    strip[i] = static_cast<std::uint8_t>(i % 4);
  }
  GlbBuilder glb = indexed(strip, uint8, strip_mode);
  Json& primitives = glb.document["meshes"][0]["primitives"];
  primitives = Json::array();
  for (int i = 0; i < 2000; ++i) {
    primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"mode", strip_mode}});
  }
  EXPECT_THAT(error_of(glb),
              HasSubstr("the scene needs more memory than a file of its size may request"));
}

}  // namespace
}  // namespace foveola::test
