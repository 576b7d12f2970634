#include <gtest/gtest.h>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/numbers/random.h"
#include "renderer/trace/lights/lights.h"
#include "tests/renderer/trace/light_outcomes.h"

namespace foveola {
namespace {

using test::every_light;

/// For places of which each has its region.
void expect_samples_of_single_points(const Lights& lights) {
  const LaneMask but_the_last{-1, -1, -1, -1, -1, -1, -1, 0};
  Pcg32 random(9);
  for (std::uint32_t i = 0; i < 500; ++i) {
    ShadingPoints shading_points;
    LightNumbers numbers;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const auto x = static_cast<float>(random.normal());
      const auto y = static_cast<float>(random.normal());
      shading_points.position.put(lane, {x, y, 0.5F});
      shading_points.normal.put(lane, {0.0F, 1.0F, 0.0F});
      shading_points.region[lane] = lights.region_of({x, y, 0.5F}, {0.0F, 1.0F, 0.0F});
      SampleStream stream(1, i, static_cast<std::uint32_t>(lane));
      numbers.kind[lane] = stream.next_1d();
      const Vec2 choice = stream.next_2d();
      const Vec2 point = stream.next_2d();
      numbers.choice.x[lane] = choice.x;
      numbers.choice.y[lane] = choice.y;
      numbers.point.x[lane] = point.x;
      numbers.point.y[lane] = point.y;
    }
    const LightSamples samples = lights.sample(shading_points, numbers, but_the_last);
    EXPECT_EQ(samples.pdf[7], 0.0F);
    for (std::size_t lane = 0; lane < 7; ++lane) {
      const auto expected = lights.sample(shading_points.at(lane), numbers.kind[lane],
                                          numbers.choice.at(lane), numbers.point.at(lane));
      if (!expected) {
        EXPECT_EQ(samples.pdf[lane], 0.0F);
        continue;
      }
      EXPECT_NEAR(samples.pdf[lane], expected->pdf, 1e-5F * expected->pdf);
      EXPECT_NEAR(samples.direction.x[lane], expected->direction.x, 1e-6F);
      EXPECT_NEAR(samples.direction.y[lane], expected->direction.y, 1e-6F);
      EXPECT_EQ(samples.radiance.y[lane], expected->radiance.y);
      EXPECT_EQ(samples.is_delta[lane] != 0, expected->is_delta);
      EXPECT_EQ(samples.to_light.z[lane], expected->to_light.z);
      EXPECT_EQ(samples.t_max[lane], expected->t_max);
    }
  }
}

TEST(LightsInLanesTest, SamplesAreThoseOfSingleShadingPoints) {
  const Scene scene = every_light();
  for (const std::size_t max_in_table : {0U, 100U}) {
    expect_samples_of_single_points(Lights(scene, {}, max_in_table));
  }
}

TEST(LightsInLanesTest, SamplesAreThoseOfSingleShadingPointsWhereLightsAreLearned) {
  const Scene scene = every_light();
  for (const std::size_t max_in_table : {0U, 100U}) {
    Lights lights(scene, {}, max_in_table);
    test::learn_two_sides(lights);
    EXPECT_NE(lights.region_of(Vec3(1, 0, 0), Vec3(0, 1, 0)),
              lights.region_of(Vec3(-1, 0, 0), Vec3(0, 1, 0)));
    expect_samples_of_single_points(lights);
  }
}

}  // namespace
}  // namespace foveola
