#include "scenes/modelling/shapes.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola::scenes {
namespace {

using std::numbers::pi;

/// The volume inside a closed shape, positive if its front faces look out (divergence theorem).
double volume(const Shape& shape) {
  double sum = 0.0;
  for (const auto& [a, b, c] : shape.triangles) {
    sum += glm::dot(shape.positions[a], glm::cross(shape.positions[b], shape.positions[c]));
  }
  return sum / 6.0;
}

double area(const Shape& shape) {
  double sum = 0.0;
  for (const auto& [a, b, c] : shape.triangles) {
    sum += 0.5 * glm::length(glm::cross(shape.positions[b] - shape.positions[a],
                                        shape.positions[c] - shape.positions[a]));
  }
  return sum;
}

DVec3 vector_area(const Shape& shape) {
  DVec3 sum(0.0);
  for (const auto& [a, b, c] : shape.triangles) {
    sum += 0.5 * glm::cross(shape.positions[b] - shape.positions[a],
                            shape.positions[c] - shape.positions[a]);
  }
  return sum;
}

TEST(Shapes, BoxHasTheVolumeAndAreaOfItsSides) {
  const Shape shape = box({1.0, 2.0, 3.0}, {3.0, 5.0, 7.0});
  EXPECT_NEAR(volume(shape), 2.0 * 3.0 * 4.0, 1e-12);
  EXPECT_NEAR(area(shape), 2.0 * (6.0 + 8.0 + 12.0), 1e-12);
}

TEST(Shapes, RoundedBoxHasSteinersVolume) {
  // A box blown up by a ball: V + A r + pi r^2 (a + b + c) + 4/3 pi r^3 (Steiner's formula).
  const DVec3 inner(0.6, 0.4, 0.2);
  const double r = 0.1;
  const double box_area = 2.0 * (0.6 * 0.4 + 0.4 * 0.2 + 0.6 * 0.2);
  const double expected =
      0.6 * 0.4 * 0.2 + box_area * r + pi * r * r * (0.6 + 0.4 + 0.2) + 4.0 / 3.0 * pi * r * r * r;
  EXPECT_NEAR(volume(rounded_box(inner + DVec3(2.0 * r), r, 16, 3)), expected, 1e-4);
}

TEST(Shapes, CylinderConeEllipsoidAndTorusApproachTheirVolumes) {
  EXPECT_NEAR(volume(cylinder(0.5, 2.0, 512)), pi * 0.25 * 2.0, 1e-4);
  EXPECT_NEAR(volume(cone(0.5, 0.2, 3.0, 512)), pi * (0.25 + 0.1 + 0.04), 1e-4);
  EXPECT_NEAR(volume(ellipsoid({1.0, 2.0, 0.5}, 256)), 4.0 / 3.0 * pi, 2e-3);
  EXPECT_NEAR(volume(torus(2.0, 0.5, 256, 256)), 2.0 * pi * pi * 2.0 * 0.25, 5e-3);
}

TEST(Shapes, TubeIsClosedAndFacesOutwards) {
  const Shape straight = tube({{0.0, 0.0, 0.0}, {0.0, 0.0, 2.0}}, 0.1, 256);
  EXPECT_NEAR(volume(straight), pi * 0.01 * 2.0, 1e-4);
  const Shape bent = tube({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 1}}, 0.1, 32);
  EXPECT_NEAR(glm::length(vector_area(bent)), 0.0, 1e-9);
  EXPECT_GT(volume(bent), 0.0);
}

TEST(Shapes, RectangleFacesTheCrossProductOfItsEdges) {
  const DVec3 normal_area = vector_area(rectangle({1, 1, 1}, {2, 0, 0}, {0, 3, 0}));
  EXPECT_NEAR(glm::length(normal_area - DVec3(0, 0, 6)), 0.0, 1e-12);
}

TEST(Shapes, PictureStandsUprightInGltfsCoordinates) {
  const Shape shape = picture({0, 0, 0}, {2, 0, 0}, {0, 1, 0});
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    EXPECT_EQ(shape.uvs[i].x, shape.positions[i].x / 2.0);
    EXPECT_EQ(shape.uvs[i].y, 1.0 - shape.positions[i].y);
  }
}

TEST(Shapes, PatchFacesTheCrossProductOfItsDirections) {
  const Shape shape = patch(3, 2, [](double u, double v) { return DVec3(u, 0.0, -v); });
  EXPECT_EQ(shape.triangles.size(), 12U);
  EXPECT_NEAR(vector_area(shape).y, 1.0, 1e-12);
}

TEST(Shapes, ArchHasTheAreaOfItsWallAndSoffit) {
  const ArchBay bay{.bay_width = 3.0,
                    .opening_width = 2.0,
                    .springing_height = 1.0,
                    .height = 2.5,
                    .thickness = 0.4};
  const double face = 3.0 * 2.5 - (2.0 * 1.0 + 0.5 * pi);
  const double soffit = 0.4 * (2.0 * 1.0 + pi);
  const Shape shape = arch(bay, 512);
  EXPECT_NEAR(area(shape), 2.0 * face + soffit, 1e-3);
  // The soffit alone looks down: the opening's projection onto the ground.
  EXPECT_NEAR(vector_area(shape).y, -2.0 * 0.4, 1e-9);
  EXPECT_NEAR(vector_area(shape).z, 0.0, 1e-9);
}

TEST(Shapes, TransformsKeepTheOutsideOutside) {
  const Shape shape = box(DVec3(1.0, 2.0, 3.0));
  EXPECT_NEAR(volume(scaled(shape, {-1.0, 1.0, 2.0})), 12.0, 1e-12);
  EXPECT_NEAR(volume(turned(shape, 33.0, {1, 0, 0})), 6.0, 1e-12);
  EXPECT_NEAR(volume(moved(shape, {5.0, 6.0, 7.0})), 6.0, 1e-12);
  EXPECT_NEAR(volume(inside_out(shape)), -6.0, 1e-12);
}

TEST(Shapes, PositiveTurnTakesZTowardsX) {
  Shape point;
  point.positions = {{0.0, 0.0, 1.0}};
  const DVec3 result = turned(point, 90.0).positions[0];
  EXPECT_NEAR(result.x, 1.0, 1e-12);
  EXPECT_NEAR(result.z, 0.0, 1e-12);
}

TEST(Shapes, AppendKeepsBothShapes) {
  Shape both = box(DVec3(1.0));
  append(both, moved(box(DVec3(2.0)), {10.0, 0.0, 0.0}));
  EXPECT_NEAR(volume(both), 1.0 + 8.0, 1e-9);
}

TEST(Shapes, ProjectedUvsAreLengths) {
  const Shape shape =
      with_uv_scale(with_projected_uvs(box({0, 0, 0}, {2, 1, 3}), {0, 0, 1}, {1, 0, 0}), 0.5);
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    EXPECT_EQ(shape.uvs[i].x, 0.5 * shape.positions[i].z);
    EXPECT_EQ(shape.uvs[i].y, 0.5 * shape.positions[i].x);
  }
}

}  // namespace
}  // namespace foveola::scenes
