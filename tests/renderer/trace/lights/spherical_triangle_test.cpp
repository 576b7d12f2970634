#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/trace/lights/triangle_lights.h"
#include "tests/renderer/trace/random_points.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/statistics.h"
#include "tests/renderer/view/chi_squared.h"

namespace foveola {
namespace {

using std::numbers::pi;
using test::in_cube;
using test::unit_square;

Triangle triangle_of(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  Mesh mesh;
  mesh.positions = {p0, p1, p2};
  mesh.triangles = {{0, 1, 2}};
  return {mesh, 0};
}

/// The triangle's sides as angles seen from the origin.
std::array<double, 3> arcs_of(const Triangle& t) {
  return {angle_between(t.p1, t.p2), angle_between(t.p2, t.p0), angle_between(t.p0, t.p1)};
}

/// L'Huilier's theorem.
double excess_of(const std::array<double, 3>& arcs) {
  const double s = 0.5 * (arcs[0] + arcs[1] + arcs[2]);
  const double product = std::tan(s / 2) * std::tan((s - arcs[0]) / 2) *
                         std::tan((s - arcs[1]) / 2) * std::tan((s - arcs[2]) / 2);
  return 4.0 * std::atan(std::sqrt(std::max(0.0, product)));
}

/// The integral of the direction over the triangle's solid angle (Lambert's formula for the vector
/// irradiance of a polygon).
DVec3 integral_of_direction(const Triangle& t) {
  const std::array<Vec3, 3> p{t.p0, t.p1, t.p2};
  DVec3 sum(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const DVec3 a(p[i]);
    const DVec3 b(p[(i + 1) % 3]);
    sum += angle_between(p[i], p[(i + 1) % 3]) * glm::normalize(glm::cross(a, b));
  }
  const double orientation = glm::dot(sum, DVec3(p[0] + p[1] + p[2])) < 0.0 ? -0.5 : 0.5;
  return orientation * sum;
}

TEST(SphericalTriangleTest, AnOctantIsAnEighthOfTheSphere) {
  const Triangle octant = triangle_of({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  EXPECT_NEAR(SphericalTriangle(octant, Vec3(0.0F)).solid_angle(), pi / 2.0, 1e-6);
}

TEST(SphericalTriangleTest, SolidAngleIsTheSphericalExcessAtEveryScale) {
  Pcg32 random(1);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p0 = in_cube(random, 1.0F);
    const Vec3 p1 = in_cube(random, 1.0F);
    const Vec3 p2 = in_cube(random, 1.0F);
    const Triangle t = triangle_of(p0, p1, p2);
    const double expected = excess_of(arcs_of(t));
    for (const float scale : {1e-3F, 1.0F, 1e6F}) {
      const Triangle scaled = triangle_of(scale * t.p0, scale * t.p1, scale * t.p2);
      EXPECT_NEAR(SphericalTriangle(scaled, Vec3(0.0F)).solid_angle(), expected,
                  1e-6 * expected + 1e-7);
    }
  }
}

TEST(SphericalTriangleTest, FromAfarItIsTheProjectedAreaOverTheSquaredDistance) {
  const Triangle t = triangle_of({0, 0, -100}, {0.01F, 0, -100}, {0, 0.02F, -100});
  EXPECT_NEAR(SphericalTriangle(t, Vec3(0.0F)).solid_angle(), 1e-4 / 1e4, 1e-12);
}

TEST(SphericalTriangleTest, IsNothingFromItsPlaneAndItsCorners) {
  const Triangle t = triangle_of({1, 0, 0}, {0, 1, 0}, {-1, -1, 0});
  for (const Vec3& from : {Vec3(0, 0, 0), Vec3(5, 3, 0), Vec3(1, 0, 0), Vec3(0.5F, 0.5F, 0)}) {
    const double solid_angle = SphericalTriangle(t, from).solid_angle();
    // Inside the triangle the plane is neither side: all or nothing.
    EXPECT_TRUE(solid_angle == 0.0 || from == Vec3(0.0F));
    EXPECT_TRUE(std::isfinite(solid_angle));
  }
  const Triangle point = triangle_of(Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3));
  EXPECT_EQ(SphericalTriangle(point, Vec3(0.0F)).solid_angle(), 0.0);
}

TEST(SphericalTriangleTest, JustAboveALargeTriangleItIsHalfTheSphere) {
  const Triangle t = triangle_of({1e4F, 0, -1e-2F}, {-1e4F, 2e4F, -1e-2F}, {-1e4F, -2e4F, -1e-2F});
  EXPECT_NEAR(SphericalTriangle(t, Vec3(0.0F)).solid_angle(), 2.0 * pi, 1e-5);
}

/// Large, small, needle, seen at a grazing angle, around the viewpoint.
std::vector<Triangle> various() {
  return {triangle_of({1, 0, 0}, {0, 1, 0}, {0, 0, 1}),
          triangle_of({-1, -1, -2}, {1, -1, -2}, {0.3F, 1, -2}),
          triangle_of({2, 0.1F, -3}, {2.2F, 0.1F, -3}, {2, 0.3F, -3.1F}),
          triangle_of({-3, 1, 0.5F}, {3, 1, 0.5F}, {3, 1.003F, 0.5F}),
          triangle_of({-1, -0.01F, -0.2F}, {1, -0.01F, -0.2F}, {0, -0.01F, -4}),
          triangle_of({-9, -0.1F, -8}, {9, -0.1F, -8}, {0, -0.1F, 9}),
          triangle_of({-9e3F, -0.1F, -8e3F}, {9e3F, -0.1F, -8e3F}, {0, -0.1F, 9e3F})};
}

TEST(SphericalTriangleTest, TheMeanOfTheDirectionsIsLamberts) {
  for (const Triangle& t : various()) {
    const SphericalTriangle seen(t, Vec3(0.0F));
    const DVec3 expected = integral_of_direction(t) / excess_of(arcs_of(t));
    std::array<MeanEstimate, 3> mean;
    Pcg32 random(3);
    for (int i = 0; i < 20000; ++i) {
      const Vec3 direction = glm::normalize(t.at(seen.sample(unit_square(random))));
      for (int axis = 0; axis < 3; ++axis) {
        mean[static_cast<std::size_t>(axis)].add(direction[axis]);
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      const MeanEstimate& estimate = mean[static_cast<std::size_t>(axis)];
      EXPECT_NEAR(estimate.mean(), expected[axis], 5.0 * estimate.standard_error() + 2e-5);
    }
  }
}

/// Whether a direction from the origin meets the triangle: it is on one side of all three planes
/// through the origin and a side.
bool covers(const Triangle& t, const Vec3& direction) {
  const DVec3 w(direction);
  const double s0 = glm::dot(glm::cross(DVec3(t.p0), DVec3(t.p1)), w);
  const double s1 = glm::dot(glm::cross(DVec3(t.p1), DVec3(t.p2)), w);
  const double s2 = glm::dot(glm::cross(DVec3(t.p2), DVec3(t.p0)), w);
  const double side = glm::dot(glm::cross(DVec3(t.p0), DVec3(t.p1)), DVec3(t.p2)) < 0 ? -1.0 : 1.0;
  return side * s0 > 0.0 && side * s1 > 0.0 && side * s2 > 0.0;
}

TEST(SphericalTriangleTest, DirectionsAreUniformInTheSolidAngle) {
  const std::vector<Triangle> triangles{
      triangle_of({1, 0, 0}, {0, 1, 0}, {0, 0, 1}),
      triangle_of({-1, -1, -2}, {1, -1, -2}, {0.3F, 1, -2}),
      triangle_of({-9, -0.1F, -8}, {9, -0.1F, -8}, {0, -0.1F, 9})};
  for (const Triangle& t : triangles) {
    const SphericalTriangle seen(t, Vec3(0.0F));
    const double density = 1.0 / excess_of(arcs_of(t));
    std::vector<Vec3> directions;
    Pcg32 random(4);
    for (int i = 0; i < 50000; ++i) {
      directions.push_back(glm::normalize(t.at(seen.sample(unit_square(random)))));
    }
    const double p_value = test::chi_squared_p_value(
        directions, [&](const Vec3& w) { return covers(t, w) ? density : 0.0; },
        glm::normalize(t.p0 + t.p1 + t.p2));
    EXPECT_GT(p_value, sidak_level(3));
  }
}

TEST(SphericalTriangleTest, PointsAreInTheTriangleForEveryNumber) {
  constexpr float largest = 1.0F - 0x1p-24F;
  for (const Triangle& t : various()) {
    const SphericalTriangle seen(t, Vec3(0.0F));
    for (const float x : {0.0F, 0x1p-24F, 0.5F, largest}) {
      for (const float y : {0.0F, 0x1p-24F, 0.5F, largest}) {
        const Vec2 barycentric = seen.sample({x, y});
        EXPECT_GE(barycentric.x, 0.0F);
        EXPECT_GE(barycentric.y, 0.0F);
        EXPECT_LE(barycentric.x + barycentric.y, 1.0F + 1e-6F);
      }
    }
  }
}

}  // namespace
}  // namespace foveola
