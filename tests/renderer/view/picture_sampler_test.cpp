#include <gtest/gtest.h>

#include "renderer/view/image_samplers.h"

namespace foveola {
namespace {

const Viewport view({.azimuth_rad = 0.3, .elevation_rad = -0.2},
                    {.horizontal_deg = 70.0, .vertical_deg = 40.0, .lens = {}});

std::unique_ptr<ViewSampler> aimed() {
  auto sampler = make_picture_sampler();
  sampler->aim({.viewport = view});
  return sampler;
}

TEST(PictureSampler, ASamplesPlaceIsItsPlaceInThePicture) {
  const std::vector<Vec2> points = {{0.0F, 0.0F}, {0.5F, 0.5F}, {0.25F, 0.9F}};
  std::vector<ViewSample> samples(points.size());
  aimed()->sample(points, samples);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(samples[i].image, points[i]);
    EXPECT_EQ(samples[i].direction, view.direction(points[i]));
  }
}

/// By the midpoint rule over the plane: each of the n x n cells holds 1 / n^2 of the samples.
TEST(PictureSampler, ItsDensityIsThatOfAPlane) {
  const auto sampler = aimed();
  constexpr int n = 64;
  double total = 0.0;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const Vec2 plane = (Vec2(x, y) + 0.5F) / static_cast<float>(n);
      const Vec2 step(0.5F / n);
      // Twice the triangle of the cell's corners, seen from the middle of the sphere.
      const Vec3 across =
          view.direction(plane + Vec2(step.x, 0)) - view.direction(plane - Vec2(step.x, 0));
      const Vec3 down =
          view.direction(plane + Vec2(0, step.y)) - view.direction(plane - Vec2(0, step.y));
      const double steradians = glm::length(glm::cross(across, down));
      total += sampler->density_per_sr(view.direction(plane)) * steradians;
    }
  }
  EXPECT_NEAR(total, 1.0, 1e-3);
  EXPECT_EQ(sampler->density_per_sr(-view.direction({0.5F, 0.5F})), 0.0);
}

}  // namespace
}  // namespace foveola
