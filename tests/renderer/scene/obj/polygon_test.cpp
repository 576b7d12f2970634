#include "renderer/scene/obj/polygon.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "tests/matchers.h"

namespace foveola {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

DVec3 area_vector(const std::vector<Vec3>& corners, const std::array<std::uint32_t, 3>& t) {
  const DVec3 a(corners[t[0]]);
  return 0.5 * glm::cross(DVec3(corners[t[1]]) - a, DVec3(corners[t[2]]) - a);
}

/// That the triangles all face `normal` and their areas sum up to `area`: only a partition does
/// both.
void expect_partition(const std::vector<Vec3>& corners, const Vec3& normal, double area) {
  const Triangles triangles = triangulate(corners);
  EXPECT_EQ(triangles.size(), corners.size() - 2);
  double sum = 0.0;
  for (const auto& triangle : triangles) {
    const DVec3 piece = area_vector(corners, triangle);
    const double facing = glm::dot(piece, DVec3(normal));
    EXPECT_GE(facing, -1e-9);
    EXPECT_NEAR(glm::length(piece), facing, 1e-6);
    sum += facing;
  }
  EXPECT_NEAR(sum, area, 1e-5);
}

TEST(Polygon, ConvexOnesAreFansAroundTheirFirstCorner) {
  EXPECT_THAT(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
              ElementsAre(std::array{0U, 1U, 2U}, std::array{0U, 2U, 3U}));
  EXPECT_THAT(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
              ElementsAre(std::array{0U, 1U, 2U}));
}

/// An arrowhead whose reflex corner is 2: the diagonal through corner 0 is the only one inside.
TEST(Polygon, CutsQuadsAtTheirReflexCorner) {
  const std::vector<Vec3> arrow{{0, 0, 0}, {2, 2, 0}, {0, 1, 0}, {-2, 2, 0}};
  expect_partition(arrow, {0, 0, 1}, 2.0);
  const std::vector<Vec3> turned{{2, 2, 0}, {0, 1, 0}, {-2, 2, 0}, {0, 0, 0}};
  expect_partition(turned, {0, 0, 1}, 2.0);
}

/// A comb of n teeth, each 1 wide and 3 high on a bar of height 1, gaps of 1.
std::vector<Vec3> comb(int teeth) {
  std::vector<Vec3> corners{{0, 0, 0}, {2.0F * static_cast<float>(teeth) - 1.0F, 0, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const float left = 2.0F * static_cast<float>(i);
    corners.insert(corners.end(), {{left + 1, 4, 0}, {left, 4, 0}});
    if (i > 0) {
      corners.insert(corners.end(), {{left, 1, 0}, {left - 1, 1, 0}});
    }
  }
  return corners;
}

TEST(Polygon, CutsCombsFromAnySide) {
  const int teeth = 20;
  const double area = (2.0 * teeth - 1.0) + 3.0 * teeth;
  const std::vector<Vec3> flat = comb(teeth);
  expect_partition(flat, {0, 0, 1}, area);
  std::vector<Vec3> reversed(flat.rbegin(), flat.rend());
  expect_partition(reversed, {0, 0, -1}, area);
  std::vector<Vec3> tilted;
  for (const Vec3& corner : flat) {
    tilted.emplace_back(0.6F * corner.x + 7.0F, corner.y, 0.8F * corner.x);
  }
  expect_partition(tilted, {-0.8F, 0, 0.6F}, area);
}

TEST(Polygon, RegularPolygonsOfAnySizeAreCovered) {
  const int count = 10000;
  std::vector<Vec3> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    corners.emplace_back(std::cos(angle), 0.0, -std::sin(angle));
  }
  expect_partition(corners, {0, 1, 0}, 0.5 * count * std::sin(2.0 * std::numbers::pi / count));
}

/// Corners on an edge, and one given twice.
TEST(Polygon, CollinearAndRepeatedCornersDoNoHarm) {
  expect_partition({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}},
                   {0, 0, 1}, 4.0);
  expect_partition({{1, 0, 0}, {2, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0, 0, 0}}, {0, 0, 1},
                   2.0);
}

/// A square ring of sides 4 and 2, made one polygon by a seam along which it runs twice.
TEST(Polygon, HolesOnASeamStayOpen) {
  expect_partition({{0, 0, 0},
                    {4, 0, 0},
                    {4, 4, 0},
                    {0, 4, 0},
                    {0, 0, 0},
                    {1, 1, 0},
                    {1, 3, 0},
                    {3, 3, 0},
                    {3, 1, 0},
                    {1, 1, 0}},
                   {0, 0, 1}, 12.0);
}

TEST(Polygon, WhatIsNoPolygonStillEnds) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_EQ(triangulate(std::vector<Vec3>(50, Vec3(1.0F))).size(), 48U);
  EXPECT_EQ(triangulate(std::vector<Vec3>{{0, 0, 0}, {nan, 0, 0}, {1, 1, 0}, {0, 1, 0}}).size(),
            2U);
  std::vector<Vec3> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4.0 * std::numbers::pi * i / 5.0;
    star.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  EXPECT_EQ(triangulate(star).size(), 3U);
}

TEST(Polygon, RefusesConcaveOnesOfTooManyCorners) {
  EXPECT_NO_THROW(triangulate(comb(250)));
  EXPECT_THROW(triangulate(comb(1200)), std::length_error);
}

}  // namespace
}  // namespace foveola
