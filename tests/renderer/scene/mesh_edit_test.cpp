#include "renderer/scene/mesh_edit.h"

#include <limits>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola {
namespace {

using ::testing::ElementsAre;
using Corners = std::array<std::uint32_t, 3>;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(MeshEdit, DropsTogetherWhatOnlyDegenerateTrianglesUsed) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 9}, {0, 0, 2}, {0, 0, 3}, {0, 0, 4}};
  mesh.colors = {Vec4(0), Vec4(9), Vec4(2), Vec4(3), Vec4(4)};
  mesh.tangents = mesh.colors;
  mesh.uv_sets = {{{0, 0}, {9, 9}, {2, 2}, {3, 3}, {4, 4}}};
  mesh.triangles = {{0, 1, 1}, {0, 2, 3}, {0, 2, 4}};
  EXPECT_EQ(drop_degenerate_triangles(mesh), 2U);
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}));
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
  EXPECT_THAT(mesh.normals, ElementsAre(Vec3(0, 0, 1), Vec3(0, 0, 2), Vec3(0, 0, 3)));
  EXPECT_THAT(mesh.colors, ElementsAre(Vec4(0), Vec4(2), Vec4(3)));
  EXPECT_THAT(mesh.tangents, ElementsAre(Vec4(0), Vec4(2), Vec4(3)));
  EXPECT_THAT(mesh.uv_sets, ElementsAre(ElementsAre(Vec2(0, 0), Vec2(2, 2), Vec2(3, 3))));
}

TEST(MeshEdit, KeepsTinyTriangles) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1e-30F, 0, 0}, {0, 1e-30F, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(drop_degenerate_triangles(mesh), 0U);
}

TEST(MeshEdit, RepairsOnlyNormalsWithoutDirection) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals = {{0, 0, 0}, {infinity, 0, 0}, {0, 3, 4}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(repair_normals(mesh), 2U);
  EXPECT_THAT(mesh.normals, ElementsAre(Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0.6F, 0.8F)));
}

TEST(MeshEdit, RepairsTextureCoordinates) {
  Mesh mesh;
  mesh.uv_sets = {{{1, 2}, {nan, 1}}, {{1, infinity}, {3, 4}}};
  EXPECT_EQ(repair_uvs(mesh), 2U);
  EXPECT_THAT(mesh.uv_sets, ElementsAre(ElementsAre(Vec2(1, 2), Vec2(0, 0)),
                                        ElementsAre(Vec2(0, 0), Vec2(3, 4))));
}

TEST(MeshEdit, RepairsColours) {
  Mesh mesh;
  mesh.colors = {{0.5F, 1, 0, 1}, {infinity, -infinity, nan, 2}};
  EXPECT_EQ(repair_colors(mesh), 1U);
  EXPECT_THAT(mesh.colors, ElementsAre(Vec4(0.5F, 1, 0, 1), Vec4(1, 0, 1, 1)));
}

/// Positions far from the origin come out as exact as floats near it can be.
TEST(MeshEdit, TransformsInDoublePrecision) {
  Mesh mesh;
  mesh.positions = {{0.25F, 0, 0}};
  transform(mesh, glm::translate(DMat4(1.0), DVec3(1e9, 0, 0)) *
                      glm::translate(DMat4(1.0), DVec3(-1e9, 0, 0)));
  EXPECT_EQ(mesh.positions[0], Vec3(0.25F, 0, 0));
}

TEST(MeshEdit, AMirrorTurnsTrianglesAndTangentsSigns) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.tangents = {{1, 0, 0, 1}, {1, 0, 0, -1}, {0, 1, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  transform(mesh, glm::scale(DMat4(1.0), DVec3(-2.0, 1.0, 1.0)));
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 2, 1}));
  EXPECT_THAT(mesh.tangents, ElementsAre(Vec4(-1, 0, 0, -1), Vec4(-1, 0, 0, 1), Vec4(0, 1, 0, -1)));
}

}  // namespace
}  // namespace foveola
