#include "renderer/trace/lights/light_choice.h"

#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

std::vector<double> frequencies(const AliasTable& table, std::size_t items, int draws) {
  std::vector<double> counts(items, 0.0);
  Pcg32 random(7);
  for (int i = 0; i < draws; ++i) {
    const float x = unit_float(random.next());
    const float y = unit_float(random.next());
    counts[table.sample({x, y})] += 1.0;
  }
  return counts;
}

TEST(AliasTableTest, DrawsByWeight) {
  const std::vector<double> weights{0.1, 3.0, 0.0, 0.7, 12.0, 1e-3, 2.0};
  constexpr int draws = 200000;
  const std::vector<double> counts = frequencies(AliasTable(weights), weights.size(), draws);
  double total = 0.0;
  for (const double weight : weights) {
    total += weight;
  }
  std::vector<double> expected(weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    expected[i] = weights[i] / total * draws;
  }
  EXPECT_GT(chi_squared_p_value(counts, expected), 1e-3);
  EXPECT_EQ(counts[2], 0.0);
}

TEST(AliasTableTest, OneItemIsAlwaysDrawn) {
  EXPECT_EQ(frequencies(AliasTable(std::vector<double>{1e-30}), 1, 100)[0], 100.0);
}

TEST(AliasTableTest, EqualWeightsDivideTheSquareEqually) {
  const AliasTable table(std::vector<double>(3, 0.1));
  EXPECT_EQ(table.sample({0.0F, 0.999F}), 0U);
  EXPECT_EQ(table.sample({0.5F, 0.999F}), 1U);
  EXPECT_EQ(table.sample({0x1.fffffep-1F, 0x1.fffffep-1F}), 2U);
}

}  // namespace
}  // namespace foveola
