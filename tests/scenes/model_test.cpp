#include "scenes/modelling/model.h"

#include <cmath>

#include <gtest/gtest.h>

namespace foveola::scenes {
namespace {

Surface only_surface(const Shape& shape, double crease_deg) {
  Model model;
  const int material = add_material(model, {.name = "plain"});
  add_object(model, "thing", {{material, shape, crease_deg}});
  return model.objects.at(0).surfaces.at(0);
}

TEST(Model, EdgesBeyondTheCreaseAngleStaySharp) {
  const Surface surface = only_surface(box(DVec3(2.0)), 40.0);
  EXPECT_EQ(surface.positions.size(), 24U);
  for (const Vec3& normal : surface.normals) {
    EXPECT_EQ(glm::abs(normal.x) + glm::abs(normal.y) + glm::abs(normal.z), 1.0F);
  }
}

TEST(Model, EdgesWithinTheCreaseAngleAreSmoothAcrossTheSeam) {
  const Surface surface = only_surface(ellipsoid(DVec3(1.0), 64), 40.0);
  // A welded sphere of 64 x 32 cells: 31 rings of 64 vertices and two poles, once each.
  EXPECT_EQ(surface.positions.size(), 31U * 64U + 2U);
  for (std::size_t i = 0; i < surface.normals.size(); ++i) {
    EXPECT_NEAR(glm::dot(surface.normals[i], surface.positions[i]), 1.0F, 1e-3F);
  }
}

TEST(Model, TrianglesWithoutAreaAreDropped) {
  // Each pole's row of 8 cells has lost one of its two triangles per cell.
  const Surface surface = only_surface(ellipsoid(DVec3(1.0), 8), 80.0);
  EXPECT_EQ(surface.triangles.size(), 8U * 4U * 2U - 2U * 8U);
}

TEST(Model, UvsAreKeptOnlyUnderAnImage) {
  Model model;
  const int plain = add_material(model, {.name = "plain"});
  const int textured =
      add_textured_material(model, "textured", Image{1, 1, {255, 255, 255, 255}}, 0.5F);
  add_object(model, "thing", {{plain, box(DVec3(1.0))}, {textured, box(DVec3(1.0))}});
  EXPECT_TRUE(model.objects[0].surfaces[0].uvs.empty());
  EXPECT_EQ(model.objects[0].surfaces[1].uvs.size(), model.objects[0].surfaces[1].positions.size());
  EXPECT_EQ(model.triangle_count(), 24U);
}

TEST(Model, DifferencesFarBelowAMicrometreDisappear) {
  Shape noisy = box(DVec3(1.0));
  for (std::size_t i = 0; i < noisy.positions.size(); ++i) {
    noisy.positions[i] += DVec3(1e-15 * static_cast<double>(i % 3));
  }
  const Surface surface = only_surface(noisy, 80.0);
  EXPECT_EQ(surface.positions, only_surface(box(DVec3(1.0)), 80.0).positions);
}

}  // namespace
}  // namespace foveola::scenes
