#include "analysis/statistics/models/order_balance.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "analysis/statistics/distributions.h"
#include "renderer/base/numbers/random.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

PositionCounts no_counts(std::size_t methods) {
  return PositionCounts(methods, std::vector<std::size_t>(methods, 0));
}

/// Calls `visit` with the counts of every sequence of `blocks` orders of three methods.
template <typename Visit>
void for_each_design(int blocks, PositionCounts& counts, const Visit& visit) {
  if (blocks == 0) {
    visit(counts);
    return;
  }
  std::vector<std::size_t> positions = {0, 1, 2};
  do {
    for (std::size_t method = 0; method < 3; ++method) {
      ++counts[method][positions[method]];
    }
    for_each_design(blocks - 1, counts, visit);
    for (std::size_t method = 0; method < 3; ++method) {
      --counts[method][positions[method]];
    }
  } while (std::next_permutation(positions.begin(), positions.end()));
}

TEST(OrderBalance, OverAllDesignsTheStatisticsMeanIsItsDegreesOfFreedom) {
  for (const int blocks : {1, 2, 5}) {
    PositionCounts counts = no_counts(3);
    double sum = 0.0;
    double designs = 0.0;
    for_each_design(blocks, counts, [&](const PositionCounts& found) {
      sum += order_balance(found)->chi_squared;
      designs += 1.0;
    });
    EXPECT_NEAR(sum / designs, 4.0, 1e-10) << blocks;
  }
}

TEST(OrderBalance, OfAllDesignsOfSevenBlocksFiveInAHundredAreRejectedAtFivePercent) {
  PositionCounts counts = no_counts(3);
  double at_5_percent = 0.0;
  double at_1_percent = 0.0;
  double designs = 0.0;
  for_each_design(7, counts, [&](const PositionCounts& found) {
    const double p = order_balance(found)->p;
    at_5_percent += p < 0.05 ? 1.0 : 0.0;
    at_1_percent += p < 0.01 ? 1.0 : 0.0;
    designs += 1.0;
  });
  EXPECT_EQ(designs, 279'936.0);
  EXPECT_NEAR(at_5_percent / designs, 0.05, 0.01);
  EXPECT_NEAR(at_1_percent / designs, 0.01, 0.005);
}

/// The share of random designs that are rejected at the level must be the level, but for the chance
/// of the simulation and a tenth of it for the approximation.
void expect_level(double level, std::size_t rejected, std::size_t designs) {
  const Interval share = clopper_pearson(rejected, designs, 0.999);
  EXPECT_LE(share.low, 1.1 * level) << rejected;
  EXPECT_GE(share.high, 0.9 * level) << rejected;
}

TEST(OrderBalance, RandomDesignsAreRejectedAtTheLevelOfTheTest) {
  constexpr std::size_t designs = 10'000;
  constexpr std::size_t blocks = 80;  // 16 participants in 5 scenes
  for (const std::size_t methods : {std::size_t{2}, std::size_t{3}, std::size_t{5}}) {
    SCOPED_TRACE(methods);
    Pcg32 generator(30, methods);
    std::vector<std::size_t> positions(methods);
    std::iota(positions.begin(), positions.end(), std::size_t{0});
    std::size_t at_5_percent = 0;
    std::size_t at_1_percent = 0;
    for (std::size_t design = 0; design < designs; ++design) {
      PositionCounts counts = no_counts(methods);
      for (std::size_t block = 0; block < blocks; ++block) {
        shuffle(std::span(positions), generator);
        for (std::size_t method = 0; method < methods; ++method) {
          ++counts[method][positions[method]];
        }
      }
      const double p = order_balance(counts)->p;
      at_5_percent += p < 0.05 ? 1 : 0;
      at_1_percent += p < 0.01 ? 1 : 0;
    }
    if (methods > 2) {  // the counts of two methods are too coarse for a level of their own
      expect_level(0.05, at_5_percent, designs);
      expect_level(0.01, at_1_percent, designs);
    } else {
      EXPECT_LE(at_5_percent, designs * 6 / 100);
      EXPECT_LE(at_1_percent, designs * 15 / 1000);
    }
  }
}

TEST(OrderBalance, TwoMethodsAreASignTest) {
  const OrderBalance balance = order_balance({{30, 50}, {50, 30}}).value();
  EXPECT_EQ(balance.blocks, 80U);
  EXPECT_EQ(balance.fewest, 30U);
  EXPECT_EQ(balance.most, 50U);
  // (30 - 50)^2 / 80, as McNemar's test; P by R's pchisq(5, 1, lower.tail = FALSE).
  EXPECT_DOUBLE_EQ(balance.chi_squared, 5.0);
  EXPECT_EQ(balance.degrees_of_freedom, 1.0);
  EXPECT_GOLDEN(balance.p, 0.025347318677468304);
}

TEST(OrderBalance, ALatinSquareIsBalanced) {
  const OrderBalance balance = order_balance({{4, 4, 4}, {4, 4, 4}, {4, 4, 4}}).value();
  EXPECT_EQ(balance.chi_squared, 0.0);
  EXPECT_EQ(balance.p, 1.0);
}

TEST(OrderBalance, OneMethodOrNoBlockHasNone) {
  EXPECT_FALSE(order_balance({}));
  EXPECT_FALSE(order_balance({{5}}));
  EXPECT_FALSE(order_balance(no_counts(3)));
}

}  // namespace
}  // namespace foveola::analysis
