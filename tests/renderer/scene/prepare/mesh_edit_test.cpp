#include "renderer/scene/prepare/mesh_edit.h"

#include <limits>

#include "tests/matchers.h"

namespace foveola {
namespace {

using Corners = std::array<std::uint32_t, 3>;

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

}  // namespace
}  // namespace foveola
