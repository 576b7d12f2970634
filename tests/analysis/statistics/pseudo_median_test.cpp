#include <algorithm>
#include <random>
#include <vector>

#include "analysis/statistics/rank_tests.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/pairs.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

/// All Walsh averages in increasing order, which pseudo_median never lists.
std::vector<double> walsh_averages(const std::vector<double>& values) {
  std::vector<double> averages;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t j = i; j < values.size(); ++j) {
      averages.push_back(0.5 * values[i] + 0.5 * values[j]);
    }
  }
  std::sort(averages.begin(), averages.end());
  return averages;
}

TEST(PseudoMedian, IsThatOfR) {
  const auto golden = golden_inference();
  int values = 0;
  int intervals = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".pseudo_median")) {
      continue;
    }
    SCOPED_TRACE(name);
    const PseudoMedian found =
        pseudo_median(differences(golden_column(matrix, 0), golden_column(matrix, 1))).value();
    EXPECT_GOLDEN(found.value, golden.at(name + ".pseudo_median"));
    ++values;
    if (golden.contains(name + ".pseudo_median_low")) {
      EXPECT_GOLDEN(found.interval->low, golden.at(name + ".pseudo_median_low"));
      EXPECT_GOLDEN(found.interval->high, golden.at(name + ".pseudo_median_high"));
      ++intervals;
    }
  }
  EXPECT_EQ(values, 10);
  EXPECT_EQ(intervals, 6);
}

TEST(PseudoMedian, FewValuesHaveNoInterval) {
  EXPECT_FALSE(pseudo_median(std::vector<double>{}));
  const PseudoMedian two = pseudo_median(std::vector<double>{1.0, 4.0}).value();
  EXPECT_EQ(two.value, 2.5);
  EXPECT_FALSE(two.interval);
  EXPECT_FALSE(pseudo_median(std::vector<double>{1, 2, 3, 4, 5})->interval);
  EXPECT_TRUE(pseudo_median(std::vector<double>{1, 2, 3, 4, 5, 6})->interval);
}

TEST(PseudoMedian, ConstantValuesAreIt) {
  const PseudoMedian found = pseudo_median(std::vector<double>(7, -0.1)).value();
  EXPECT_EQ(found.value, -0.1);
  EXPECT_EQ(found.interval->low, -0.1);
  EXPECT_EQ(found.interval->high, -0.1);
}

TEST(PseudoMedian, OfManyIsThatOfTheListedAverages) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 2.0);
  std::vector<double> values(501);
  std::generate(values.begin(), values.end(), [&] { return uniform(random); });
  const std::vector<double> averages = walsh_averages(values);
  const PseudoMedian found = pseudo_median(values).value();
  EXPECT_EQ(found.value, averages[averages.size() / 2]);
  // The order statistics that the normal approximation picks: 62 875.5 - 1.959964 x 3 242.02 - 0.5.
  EXPECT_EQ(found.interval->low, averages[56521 - 1]);
  EXPECT_EQ(found.interval->high, averages[averages.size() - 56521]);
}

}  // namespace
}  // namespace foveola::analysis
