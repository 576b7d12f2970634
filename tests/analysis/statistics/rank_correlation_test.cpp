#include <cmath>

#include "analysis/statistics/correlation.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(RankCorrelation, SpearmansIsThatOfR) {
  const auto golden = golden_inference();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".rho")) {
      continue;
    }
    SCOPED_TRACE(name);
    const Correlation found =
        spearman(golden_column(matrix, 0), golden_column(matrix, 1), 0.95, 0).value();
    EXPECT_FALSE(found.exact);
    EXPECT_GOLDEN(found.r, golden.at(name + ".rho"));
    EXPECT_GOLDEN(found.p, golden.at(name + ".rho_p"));
    EXPECT_GOLDEN(found.interval->low, golden.at(name + ".rho_low"));
    EXPECT_GOLDEN(found.interval->high, golden.at(name + ".rho_high"));
    ++compared;
  }
  EXPECT_GE(compared, 6);
}

TEST(RankCorrelation, OfFewPairsThePValueIsExact) {
  const auto golden = golden_inference();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".rho_p_exact")) {
      continue;
    }
    SCOPED_TRACE(name);
    const Correlation found = spearman(golden_column(matrix, 0), golden_column(matrix, 1)).value();
    EXPECT_TRUE(found.exact);
    EXPECT_GOLDEN(found.p, golden.at(name + ".rho_p_exact"));
    ++compared;
  }
  EXPECT_GE(compared, 7);
}

TEST(RankCorrelation, AboveNinePairsThePValueIsApproximate) {
  const std::vector<double> x = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  const std::vector<double> y = {2, 1, 4, 3, 6, 5, 8, 7, 10, 9};
  EXPECT_FALSE(spearman(x, y)->exact);
  EXPECT_TRUE(spearman(std::span(x).first(9), std::span(y).first(9))->exact);
}

TEST(RankCorrelation, ConstantOrFewValuesHaveNone) {
  EXPECT_FALSE(spearman(std::vector<double>{1, 1, 1}, std::vector<double>{1, 2, 3}));
  EXPECT_FALSE(spearman(std::vector<double>{1, 2}, std::vector<double>{1, 2}));
}

}  // namespace
}  // namespace foveola::analysis
