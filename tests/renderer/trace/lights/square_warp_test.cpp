#include <vector>

#include <gtest/gtest.h>

#include "renderer/trace/lights/learned_lights.h"
#include "tests/renderer/trace/random_points.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

std::array<double, SquareWarp::squares> some_weights() {
  std::array<double, SquareWarp::squares> weights;
  Pcg32 random(7);
  for (double& weight : weights) {
    weight = random.exponential();
  }
  weights[9] = 1e-9;
  return weights;
}

TEST(SquareWarpTest, DrawsSquaresByWeightAndUniformlyWithin) {
  const auto weights = some_weights();
  const SquareWarp warp(weights);
  double total = 0.0;
  for (const double weight : weights) {
    total += weight;
  }
  constexpr int draws = 200'000;
  std::vector<double> observed(2 * weights.size(), 0.0);
  std::vector<double> expected(observed.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    expected[i] = 0.5 * draws * weights[i / 2] / total;
  }
  Pcg32 random(1);
  for (int i = 0; i < draws; ++i) {
    const auto point = warp.sample(test::unit_square(random));
    const std::size_t square = SquareWarp::square_of(point.place);
    EXPECT_EQ(point.density, warp.density(point.place));
    EXPECT_EQ(point.density, warp.density_in(square));
    const Vec2 scaled = point.place * static_cast<float>(SquareWarp::width);
    const bool is_lower = glm::fract(scaled.x) + glm::fract(scaled.y) < 1.0F;
    observed[2 * square + (is_lower ? 1 : 0)] += 1.0;
  }
  EXPECT_GT(chi_squared_p_value(observed, expected), sidak_level(1));
}

TEST(SquareWarpTest, DensityHasTheMeanOne) {
  const SquareWarp warp(some_weights());
  double sum = 0.0;
  for (std::size_t i = 0; i < SquareWarp::squares; ++i) {
    sum += warp.density_in(i);
  }
  EXPECT_NEAR(sum / SquareWarp::squares, 1.0, 1e-6);
}

TEST(SquareWarpTest, TheEndsOfTheSquareStayInIt) {
  const SquareWarp warp(some_weights());
  for (const float u : {0.0F, largest_below_one, 1.0F}) {
    const Vec2 place = warp.sample(Vec2(u)).place;
    EXPECT_GE(place.x, 0.0F);
    EXPECT_LT(place.x, 1.0F);
    EXPECT_LT(SquareWarp::square_of(Vec2(u)), SquareWarp::squares);
  }
}

}  // namespace
}  // namespace foveola
