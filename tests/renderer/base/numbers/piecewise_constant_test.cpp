#include "renderer/base/numbers/piecewise_constant.h"

#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
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

/// Of a large grid with gaps, empty rows and a cell that has half of everything.
TEST(PiecewiseConstantTest, DrawsTheCellInWhichTheNumbersFall) {
  constexpr std::size_t width = 333;
  constexpr std::size_t height = 70;
  std::vector<float> sparse(width * height, 0.0F);
  Pcg32 random(5);
  double total = 0.0;
  for (std::size_t i = 0; i < sparse.size(); ++i) {
    if (i / width % 7 != 3 && random.below(5) == 0) {
      sparse[i] = static_cast<float>(random.exponential());
      total += sparse[i];
    }
  }
  sparse[50 * width + 200] = static_cast<float>(total);
  const PiecewiseConstant2D grid(width, height, sparse);
  std::vector<double> rows_before(height + 1, 0.0);
  for (std::size_t row = 0; row < height; ++row) {
    double sum = 0.0;
    for (std::size_t column = 0; column < width; ++column) {
      sum += grid.probability(column, row);
    }
    rows_before[row + 1] = rows_before[row] + sum;
  }
  for (int i = 0; i < 20000; ++i) {
    const Vec2 u(i < 100 ? 0.01F * static_cast<float>(i) : unit_float(random.next()),
                 unit_float(random.next()));
    const PiecewiseConstant2D::Point point = grid.sample(u);
    EXPECT_LE(rows_before[point.row], u.y + 1e-5);
    EXPECT_GE(rows_before[point.row + 1], u.y - 1e-5);
    const double row_sum = rows_before[point.row + 1] - rows_before[point.row];
    double before = 0.0;
    for (std::size_t column = 0; column < point.column; ++column) {
      before += grid.probability(column, point.row) / row_sum;
    }
    EXPECT_LE(before, u.x + 1e-4);
    EXPECT_GE(before + point.probability / row_sum, u.x - 1e-4);
    EXPECT_GT(point.probability, 0.0F);
  }
}

TEST(PiecewiseConstantTest, PlacesOfPointsAreTheNumbersThatDrawThem) {
  const PiecewiseConstant2D grid(3, 4, weights);
  Pcg32 random(13);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 u{unit_float(random.next()), unit_float(random.next())};
    const Vec2 place = grid.place_of(grid.sample(u));
    EXPECT_NEAR(place.x, u.x, 1e-6F);
    EXPECT_NEAR(place.y, u.y, 1e-6F);
  }
}

TEST(PiecewiseConstantTest, WithoutWeightTheTotalIsZero) {
  EXPECT_EQ(PiecewiseConstant2D(2, 1, std::vector<float>(2, 0.0F)).total(), 0.0);
}

}  // namespace
}  // namespace foveola
