#include "renderer/base/piecewise_constant.h"

#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/random.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

const std::vector<float> weights{0.0F, 1.0F, 2.0F,  //
                                 0.0F, 0.0F, 0.0F,  //
                                 5.0F, 0.0F, 0.5F,  //
                                 1.5F, 3.0F, 0.0F};

TEST(PiecewiseConstantTest, ProbabilityIsTheShareOfTheWeight) {
  const PiecewiseConstant2D grid(3, 4, weights);
  EXPECT_DOUBLE_EQ(grid.total(), 13.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_NEAR(grid.probability(i % 3, i / 3), weights[i] / 13.0, 1e-6);
  }
}

TEST(PiecewiseConstantTest, DrawsCellsByProbabilityAndUniformlyWithin) {
  const PiecewiseConstant2D grid(3, 4, weights);
  constexpr int draws = 200000;
  constexpr std::size_t halves = 2;  // along each side of a cell
  std::vector<double> observed(weights.size() * halves * halves, 0.0);
  std::vector<double> expected(observed.size());
  Pcg32 random(11);
  for (int i = 0; i < draws; ++i) {
    const float x = unit_float(random.next());
    const float y = unit_float(random.next());
    const auto point = grid.sample({x, y});
    const std::size_t cell = point.row * 3 + point.column;
    EXPECT_EQ(point.probability, grid.probability(point.column, point.row));
    ASSERT_LT(point.within.x, 1.0F);
    ASSERT_LT(point.within.y, 1.0F);
    observed[cell * 4 + (point.within.x < 0.5F ? 0 : 1) + (point.within.y < 0.5F ? 0 : 2)] += 1.0;
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    expected[i] = weights[i / 4] / 13.0 / 4.0 * draws;
  }
  EXPECT_GT(chi_squared_p_value(observed, expected), 1e-3);
}

TEST(PiecewiseConstantTest, BordersOfTheSquareDrawCellsWithWeight) {
  const PiecewiseConstant2D grid(3, 4, weights);
  for (const float x : {0.0F, 0x1.fffffep-1F}) {
    for (const float y : {0.0F, 0x1.fffffep-1F}) {
      EXPECT_GT(grid.sample({x, y}).probability, 0.0F) << x << ' ' << y;
    }
  }
}

TEST(PiecewiseConstantTest, WithoutWeightTheTotalIsZero) {
  EXPECT_EQ(PiecewiseConstant2D(2, 1, std::vector<float>(2, 0.0F)).total(), 0.0);
}

}  // namespace
}  // namespace foveola
