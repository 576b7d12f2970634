#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/base/numbers/random.h"
#include "renderer/view/mask_sampler.h"

namespace foveola {
namespace {

/// All black but for one pixel.
WeightImage one_pixel(int width, int height, int x, int y) {
  WeightImage image{.width = width, .height = height, .weights = {}};
  image.weights.resize(static_cast<std::size_t>(width) * height);
  image.weights[static_cast<std::size_t>(y) * width + x] = 3.0F;
  return image;
}

// 20 x 10 pixels over 80 degrees each way are 8 degrees a pixel: pixel (15, 2) lies from 40 to 48
// degrees to the right and from 16 to 24 up.
TEST(MapSampler, LaysTheImageAroundTheGazeWithTheHeadsUp) {
  MapSampler sampler(one_pixel(20, 10, 15, 2), 80.0);
  const Quat head = glm::angleAxis(2.0F, glm::normalize(Vec3(0.3F, -0.5F, 0.7F)));
  const Vec3 gaze = head * Vec3(0.0F, 0.0F, -1.0F);
  sampler.aim({.viewport = Viewport(head, 1.0, 1.0), .gaze = gaze});
  std::vector<Vec2> points;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    points.push_back(sobol_2d(i, 3));
  }
  std::vector<ViewSample> samples(points.size());
  sampler.sample(points, samples);
  for (const ViewSample& sample : samples) {
    const Vec3 local = glm::conjugate(head) * sample.direction;
    const double e = degrees(angle_between(sample.direction, gaze));
    const double azimuth = std::atan2(local.y, local.x);
    EXPECT_GE(e * std::cos(azimuth), 40.0 - 1e-4);
    EXPECT_LE(e * std::cos(azimuth), 48.0 + 1e-4);
    EXPECT_GE(e * std::sin(azimuth), 16.0 - 1e-4);
    EXPECT_LE(e * std::sin(azimuth), 24.0 + 1e-4);
  }
  // 1 / (8 x 8) a square degree, times e / sin(e), at (44, 20) degrees.
  const double e = std::hypot(44.0, 20.0);
  const Vec3 middle(std::sin(radians(e)) * 44.0 / e, std::sin(radians(e)) * 20.0 / e,
                    -std::cos(radians(e)));
  const double expected = 1.0 / 64.0 * degrees(1.0) * degrees(1.0) * radians(e) / sin(radians(e));
  EXPECT_NEAR(sampler.density_per_sr(head * middle), expected, 1e-5 * expected);
  EXPECT_EQ(sampler.density_per_sr(gaze), 0.0);
}

TEST(MapSampler, NothingLiesBeyond179Degrees) {
  WeightImage white{.width = 8, .height = 8, .weights = std::vector<float>(64, 1.0F)};
  MapSampler sampler(white, 179.0);
  sampler.aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
  EXPECT_EQ(sampler.density_per_sr({0.0F, 0.0F, 1.0F}), 0.0);
  EXPECT_GT(sampler.density_per_sr({0.0F, 1.0F, 0.0F}), 0.0);
  std::vector<Vec2> points{{0.0F, 0.0F}, {0x1.fffffep-1F, 0x1.fffffep-1F}, {0.0F, 0.5F}};
  std::vector<ViewSample> samples(points.size());
  sampler.sample(points, samples);
  for (const ViewSample& sample : samples) {
    EXPECT_LT(degrees(angle_between(sample.direction, {0.0F, 0.0F, -1.0F})), 179.0);
  }
  EXPECT_THROW(MapSampler(one_pixel(8, 8, 0, 0), 179.0), Error);
}

}  // namespace
}  // namespace foveola
