#include "renderer/stability/shapes.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

namespace foveola {
namespace {

using Corner = std::tuple<float, float, float>;

Corner corner_of(const Mesh& mesh, std::uint32_t vertex) {
  const Vec3& p = mesh.positions[vertex];
  return {p.x, p.y, p.z};
}

/// Every edge is met once in each direction, by equal coordinates: closed, and oriented.
void expect_watertight(const Mesh& mesh) {
  std::map<std::pair<Corner, Corner>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{corner_of(mesh, triangle[i]), corner_of(mesh, triangle[(i + 1) % 3])}];
    }
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
}

/// By the divergence theorem; negative where the fronts are inside.
double signed_volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += glm::dot(DVec3(mesh.positions[a]),
                    glm::cross(DVec3(mesh.positions[b]), DVec3(mesh.positions[c]))) /
           6.0;
  }
  return sum;
}

TEST(ShapesTest, ClosedShapesAreWatertightWhereverTheyArePlaced) {
  const double pi = std::numbers::pi;
  const struct {
    Mesh mesh;
    double volume;
    double tolerance;
  } shapes[] = {{inward_box(Vec3(0.0F), 1.5F, 0), -27.0, 1e-5},
                {tessellated_inward_box(Vec3(0.0F), 0.5F, 13, 0), -1.0, 1e-5},
                {inward_tetrahedron(2.0F, 9, 0), -64.0 / (9.0 * std::sqrt(3.0)), 1e-5},
                {inward_sphere(2.0F, 4, 0), -32.0 / 3.0 * pi, 0.01},
                {torus(1.0F, 0.25F, 64, 0), 2.0 * pi * pi * 0.0625, 0.01}};
  for (const auto& shape : shapes) {
    EXPECT_NEAR(signed_volume(shape.mesh), shape.volume, shape.tolerance * std::abs(shape.volume));
    const Quat turn = glm::angleAxis(0.7F, glm::normalize(Vec3(1, 2, -1)));
    expect_watertight(placed(shape.mesh, 3.7F, turn, Vec3(100.1F, -70.3F, 20.7F)));
    EXPECT_NEAR(signed_volume(inside_out(shape.mesh)), -signed_volume(shape.mesh), 1e-6);
  }
}

TEST(ShapesTest, NormalsPointToTheFront) {
  for (const Mesh& mesh : {inward_sphere(2.0F, 2, 0), torus(1.0F, 0.25F, 24, 0),
                           inside_out(inward_sphere(0.5F, 2, 0))}) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 front =
          glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
      ASSERT_GT(glm::dot(front, mesh.normals[a]), 0.9F * glm::length(front));
    }
    EXPECT_TRUE(flat_shaded(mesh).normals.empty());
  }
}

TEST(ShapesTest, QuadsFaceTheProductOfTheirSides) {
  const Vec3 a(2, 0, 0);
  const Vec3 b(0, 0, -3);
  for (const Mesh& mesh : {quad(Vec3(1.0F), a, b, 7), tessellated_quad(Vec3(1.0F), a, b, 5, 7)}) {
    EXPECT_EQ(mesh.material, 7);
    double area = 0.0;
    for (const auto& [i, k, l] : mesh.triangles) {
      const Vec3 front =
          glm::cross(mesh.positions[k] - mesh.positions[i], mesh.positions[l] - mesh.positions[i]);
      EXPECT_GT(front.y, 0.0F);
      area += 0.5 * glm::length(front);
    }
    EXPECT_NEAR(area, 6.0, 1e-5);
  }
}

TEST(ShapesTest, PlacedScalesThenTurnsThenMoves) {
  const Quat quarter = glm::angleAxis(0.5F * std::numbers::pi_v<float>, Vec3(0, 1, 0));
  Mesh mesh = quad(Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), 0);
  mesh.normals.assign(4, Vec3(1, 0, 0));
  mesh = placed(mesh, 2.0F, quarter, Vec3(5, 6, 7));
  EXPECT_NEAR(glm::length(mesh.positions[0] - Vec3(5, 6, 5)), 0.0F, 1e-5F);
  EXPECT_NEAR(glm::length(mesh.normals[0] - Vec3(0, 0, -1)), 0.0F, 1e-6F);
}

}  // namespace
}  // namespace foveola
