#include "renderer/progressive/framing.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/stability/shapes.h"

namespace foveola::test {
namespace {

constexpr AzimuthElevation askew{.azimuth_rad = -0.5, .elevation_rad = -0.35};
const FieldOfView wide{.horizontal_deg = 60.0, .vertical_deg = 36.0, .lens = {}};

/// The part of the picture, each way, that the points take up around its middle; above 1 if some
/// are outside.
Vec2 extent_of(const std::vector<Vec3>& points, const Vec3& camera) {
  const Viewport view(askew, {.horizontal_deg = 120.0, .vertical_deg = 120.0, .lens = {}});
  const Vec2 scale(std::tan(radians(60.0)) / std::tan(radians(30.0)),
                   std::tan(radians(60.0)) / std::tan(radians(18.0)));
  Vec2 largest(0.0F);
  Vec2 smallest(1e9F);
  for (const Vec3& point : points) {
    const std::optional<Vec2> plane = view.project(glm::normalize(point - camera));
    if (!plane) {
      return Vec2(2.0F);
    }
    const Vec2 from_middle = scale * (2.0F * *plane - 1.0F);
    largest = glm::max(largest, from_middle);
    smallest = glm::min(smallest, from_middle);
  }
  EXPECT_NEAR(largest.x, -smallest.x, 0.2F) << "not in the middle";
  return glm::max(largest, -smallest);
}

TEST(Framing, FillsThePictureButForAMargin) {
  const std::vector<Vec3> points = {{-1, 0, -1}, {1, 0.2F, 1}, {1, 3, -1}, {-0.5F, 2, 1}};
  Framing framing(askew, wide);
  for (const Vec3& point : points) {
    framing.include(point);
  }
  const Vec2 extent = extent_of(points, framing.position());
  EXPECT_NEAR(std::max(extent.x, extent.y), 0.9F, 1e-3F);
}

TEST(Framing, OfAnObjectIsThatOfItsVerticesInTheWorld) {
  Scene scene;
  scene.materials = {matte(Rgb(0.5F))};
  scene.prototypes = {inward_box(Vec3(0.0F), 1.0F, 0)};
  scene.instances.resize(1);
  scene.instances[0].world_from_local[3] = Vec4(5.0F, 0.0F, 0.0F, 1.0F);
  Framing of_object(askew, wide);
  of_object.include(scene, 0);
  Framing of_bounds(askew, wide);
  of_bounds.include(Bounds{.lower = {4, -1, -1}, .upper = {6, 1, 1}});
  EXPECT_LT(glm::distance(of_object.position(), of_bounds.position()), 1e-5F);
}

TEST(Framing, ScalesWithWhatItIsOf) {
  const auto place = [](float size) {
    Framing framing(askew, wide);
    framing.include(Bounds{.lower = Vec3(-size), .upper = Vec3(size)});
    return framing.position();
  };
  EXPECT_LT(glm::distance(place(1e-3F), 1e-3F * place(1.0F)), 1e-8F);
  EXPECT_LT(glm::distance(place(1e6F), 1e6F * place(1.0F)), 1.0F);
}

}  // namespace
}  // namespace foveola::test
