#include "renderer/scene/prepare/tangents.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

constexpr Mat3x2 identity{1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F};

void expect_near(const Vec3& actual, const Vec3& expected, float tolerance = 1e-6F) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

/// Where the image's upward direction lies on the surface, by the specification's formula.
Vec3 bitangent(const Mesh& mesh, std::size_t vertex) {
  const Vec4& tangent = mesh.tangents[vertex];
  return tangent.w * glm::cross(mesh.normals[vertex], Vec3(tangent));
}

/// A square in the plane z = 0 seen from +Z: lower left, lower right, upper right, upper left.
Mesh textured_square(const std::vector<Vec2>& uvs) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uv_sets = {uvs};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// An image pasted upright: its lower left corner, (u, v) = (0, 1), at the lower left.
TEST(Tangents, LieAlongTheImage) {
  Mesh mesh = textured_square({{0, 1}, {1, 1}, {1, 0}, {0, 0}});
  add_tangents(mesh, 0, identity);
  ASSERT_EQ(mesh.tangents.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(mesh.tangents[i], Vec4(1, 0, 0, 1));
    EXPECT_EQ(bitangent(mesh, i), Vec3(0, 1, 0));
  }
}

/// Mirrored left to right: the image's right is at -X, its top still at +Y.
TEST(Tangents, OfAMirroredImageHaveANegativeSign) {
  Mesh mesh = textured_square({{1, 1}, {0, 1}, {0, 0}, {1, 0}});
  add_tangents(mesh, 0, identity);
  EXPECT_EQ(mesh.tangents[0], Vec4(-1, 0, 0, -1));
  EXPECT_EQ(bitangent(mesh, 0), Vec3(0, 1, 0));
}

/// A quarter turn of the coordinates turns what is seen: with texture (u', v') = (v, -u), the
/// image's right, +u', is where v grows: down, at -Y.
TEST(Tangents, FollowTheTransformOfTheTexture) {
  Mesh mesh = textured_square({{0, 1}, {1, 1}, {1, 0}, {0, 0}});
  add_tangents(mesh, 0, Mat3x2(0.0F, -1.0F, 1.0F, 0.0F, 0.0F, 0.0F));
  expect_near(Vec3(mesh.tangents[0]), {0, -1, 0});
  expect_near(bitangent(mesh, 0), {1, 0, 0});
}

TEST(Tangents, AreOfTheSetThatIsNamed) {
  Mesh mesh = textured_square({{0, 1}, {1, 1}, {1, 0}, {0, 0}});
  mesh.uv_sets.push_back({{0, 0}, {0, 1}, {1, 1}, {1, 0}});  // u up, v to the right
  add_tangents(mesh, 1, identity);
  expect_near(Vec3(mesh.tangents[0]), {0, 1, 0});
}

/// Two squares that share the edge x = 0, each with the same image, mirrored at the edge as
/// symmetric models have it.
TEST(Tangents, VerticesOnASeamOfMirroringAreDoubled) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uv_sets = {{{0, 1}, {0, 0}, {1, 1}, {1, 1}}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}};
  add_tangents(mesh, 0, identity);
  ASSERT_EQ(mesh.positions.size(), 6U);
  ASSERT_EQ(mesh.tangents.size(), 6U);
  ASSERT_EQ(mesh.uv_sets[0].size(), 6U);
  for (const std::uint32_t vertex : mesh.triangles[0]) {
    EXPECT_EQ(mesh.tangents[vertex], Vec4(1, 0, 0, 1));
  }
  for (const std::uint32_t vertex : mesh.triangles[1]) {
    EXPECT_EQ(mesh.tangents[vertex], Vec4(-1, 0, 0, -1));
  }
  EXPECT_EQ(mesh.positions[mesh.triangles[1][1]], Vec3(0, 1, 0)) << "copies stand where they stood";
}

const float h = std::sqrt(0.5F);

/// The edge of a roof of two slopes, whose tangents leave it to both sides in a right angle. Each
/// slope's corners at the edge have the angle 90 degrees in one triangle, and share the normal +Z.
Mesh roof() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}, {h, 0, -h}, {-h, 0, -h}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {h, 0, h}, {-h, 0, h}};
  mesh.uv_sets = {{{0, 0}, {0, -1}, {1, 0}, {-1, 0}}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}};
  return mesh;
}

TEST(Tangents, AreAveragedInThePlaneOfTheNormal) {
  Mesh mesh = roof();
  add_tangents(mesh, 0, identity);
  expect_near(Vec3(mesh.tangents[0]), {1, 0, 0});
  expect_near(Vec3(mesh.tangents[1]), {1, 0, 0});
  expect_near(Vec3(mesh.tangents[2]), {h, 0, -h});
  expect_near(Vec3(mesh.tangents[3]), {h, 0, h});
}

/// At the origin a corner of 90 degrees where u runs along +X meets one of 45 where it runs along
/// +Y, and the image's top is at -X.
TEST(Tangents, AreWeightedByTheAngleOfTheCorner) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {-1, 1, 0}};
  mesh.normals.assign(5, {0, 0, 1});
  mesh.uv_sets = {{{0, 0}, {1, 0}, {0, -1}, {1, 0}, {1, -1}}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  add_tangents(mesh, 0, identity);
  expect_near(Vec3(mesh.tangents[0]), glm::normalize(Vec3(90, 45, 0)));
  EXPECT_EQ(mesh.tangents[1], Vec4(1, 0, 0, 1));
  EXPECT_EQ(mesh.tangents[3], Vec4(0, 1, 0, 1));
}

TEST(Tangents, OfFlatMeshesLieInEachTriangle) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
  mesh.uv_sets = {{{0, 1}, {0, 0}, {1, 1}, {-1, 1}}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}};
  add_tangents(mesh, 0, identity);
  EXPECT_TRUE(mesh.normals.empty());
  ASSERT_EQ(mesh.positions.size(), 6U);
  for (const std::uint32_t vertex : mesh.triangles[0]) {
    expect_near(Vec3(mesh.tangents[vertex]), {1, 0, 0});
  }
  for (const std::uint32_t vertex : mesh.triangles[1]) {
    expect_near(Vec3(mesh.tangents[vertex]), {0, 0, 1});
  }
}

/// Without an index list every triangle has vertices of its own; they are smooth all the same.
TEST(Tangents, EqualVerticesAreOne) {
  const Mesh shared = roof();
  Mesh own;
  own.uv_sets.resize(1);
  for (const auto& triangle : shared.triangles) {
    const auto next = static_cast<std::uint32_t>(own.positions.size());
    own.triangles.push_back({next, next + 1, next + 2});
    for (const std::uint32_t vertex : triangle) {
      own.positions.push_back(shared.positions[vertex]);
      own.normals.push_back(shared.normals[vertex]);
      own.uv_sets[0].push_back(shared.uv_sets[0][vertex]);
    }
  }
  add_tangents(own, 0, identity);
  expect_near(Vec3(own.tangents[0]), {1, 0, 0});
  expect_near(Vec3(own.tangents[3]), {1, 0, 0});
}

TEST(Tangents, AreUsableWhateverTheCoordinates) {
  Pcg32 random(1);
  const auto uniform = [&] { return static_cast<float>(random.below(1000)) / 500.0F - 1.0F; };
  for (int round = 0; round < 200; ++round) {
    Mesh mesh;
    mesh.uv_sets.resize(1);
    for (int i = 0; i < 12; ++i) {
      const float x = uniform();
      const float y = uniform();
      mesh.positions.emplace_back(x, y, uniform());
      const float nx = uniform();
      const float ny = uniform();
      mesh.normals.push_back(glm::normalize(Vec3(nx, ny, 1.0F)));
      // Few different values: many triangles without an area in the texture.
      const auto u = static_cast<float>(random.below(2));
      mesh.uv_sets[0].emplace_back(u, static_cast<float>(random.below(2)));
    }
    for (std::uint32_t i = 0; i < 20; ++i) {
      const std::uint32_t a = random.below(4);
      const std::uint32_t b = 4 + random.below(4);
      mesh.triangles.push_back({a, b, 8 + random.below(4)});
    }
    add_tangents(mesh, 0, identity);
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
      EXPECT_NEAR(glm::length(Vec3(mesh.tangents[i])), 1.0F, 1e-5F);
      EXPECT_NEAR(glm::dot(Vec3(mesh.tangents[i]), mesh.normals[i]), 0.0F, 1e-5F);
      EXPECT_EQ(std::abs(mesh.tangents[i].w), 1.0F);
    }
  }
}

TEST(StraightenTangents, MakesThemPerpendicularAndCountsTheRest) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Mesh mesh;
  mesh.normals.assign(6, {0, 0, 1});
  mesh.tangents = {{3, 0, 4, 1}, {0, 1, 0, -0.99F}, {0, 0, 0, 1},
                   {0, 0, 1, 1}, {nan, 0, 0, 1},    {1, 0, 0, 0}};
  EXPECT_EQ(straighten_tangents(mesh), 4U);
  expect_near(Vec3(mesh.tangents[0]), {1, 0, 0});
  EXPECT_EQ(mesh.tangents[1], Vec4(0, 1, 0, -1));
}

}  // namespace
}  // namespace foveola
