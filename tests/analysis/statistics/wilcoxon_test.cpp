#include <algorithm>
#include <cmath>

#include "analysis/statistics/rank_tests.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/pairs.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(Wilcoxon, RankSumsAndPValuesAreThoseOfR) {
  const auto golden = golden_inference();
  int exact = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".w_plus")) {
      continue;
    }
    SCOPED_TRACE(name);
    const std::vector<double> values =
        differences(golden_column(matrix, 0), golden_column(matrix, 1));
    const SignedRankTest test = signed_rank(values).value();
    EXPECT_EQ(static_cast<double>(test.zeros), golden.at(name + ".zeros"));
    EXPECT_GOLDEN(test.w_plus, golden.at(name + ".w_plus"));
    const SignedRankTest approximate = signed_rank(values, ZeroRule::drop, 0).value();
    EXPECT_FALSE(approximate.exact);
    EXPECT_GOLDEN(approximate.p, golden.at(name + ".p_approximate"));
    if (golden.contains(name + ".p_exact")) {
      EXPECT_TRUE(test.exact);
      EXPECT_GOLDEN(test.p, golden.at(name + ".p_exact"));
      EXPECT_GOLDEN(signed_rank(values, ZeroRule::pratt)->p, golden.at(name + ".p_exact_pratt"));
      ++exact;
    }
  }
  EXPECT_EQ(exact, 9);
}

/// The P-value by enumeration of all 2^n signs, which the dynamic programme must give.
double p_by_enumeration(const std::vector<double>& ranks, double smaller_sum) {
  std::size_t extreme = 0;
  const std::size_t all = std::size_t{1} << ranks.size();
  for (std::size_t signs = 0; signs < all; ++signs) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
      sum += (signs >> i & 1U) != 0 ? ranks[i] : 0.0;
    }
    extreme += sum <= smaller_sum ? 1 : 0;
  }
  return std::min(1.0, 2.0 * static_cast<double>(extreme) / static_cast<double>(all));
}

TEST(Wilcoxon, ExactPValuesAreThoseOfAllSigns) {
  const std::vector<double> tied = {1, 1, -1, 2, -2, 2, 3, 0, 5, -4};
  const SignedRankTest dropped = signed_rank(tied).value();
  // |d|: 1 1 1 2 2 2 3 5 4.
  EXPECT_DOUBLE_EQ(dropped.p, p_by_enumeration({2, 2, 2, 5, 5, 5, 7, 9, 8}, dropped.w_minus));
  const SignedRankTest pratt = signed_rank(tied, ZeroRule::pratt).value();
  EXPECT_DOUBLE_EQ(pratt.p, p_by_enumeration({3, 3, 3, 6, 6, 6, 8, 10, 9}, pratt.w_minus));
  EXPECT_EQ(pratt.zeros, 1U);
  EXPECT_EQ(pratt.n, 9U);
}

TEST(Wilcoxon, FourDifferencesOfOneSignHaveTheSmallestPOfFour) {
  const SignedRankTest test = signed_rank(std::vector<double>{4, 3, 7, 1}).value();
  EXPECT_DOUBLE_EQ(test.p, 2.0 / 16.0);
  EXPECT_DOUBLE_EQ(test.rank_biserial, 1.0);
  EXPECT_DOUBLE_EQ(signed_rank(std::vector<double>{-4, -3, -7, -1})->rank_biserial, -1.0);
}

TEST(Wilcoxon, ManyDifferencesOfOneSignStayExact) {
  std::vector<double> differences;
  for (int i = 1; i <= 200; ++i) {
    differences.push_back(i);
  }
  EXPECT_THAT(signed_rank(differences)->p, DoubleEq(std::ldexp(1.0, -199)));
  EXPECT_THAT(signed_rank(differences)->p_above, DoubleEq(std::ldexp(1.0, -200)));
  differences.push_back(201);
  EXPECT_FALSE(signed_rank(differences)->exact);
}

// wilcox.test(x, alternative = "greater", exact = FALSE)
TEST(Wilcoxon, OneSidedPValuesAreThoseOfR) {
  const std::vector<double> values = {0.31, -0.22, 0.54, 0.13, 0.41, -0.17, 0.28, 0.05};
  EXPECT_EQ(signed_rank(values)->p_above, 19.0 / 256.0);
  EXPECT_GOLDEN(signed_rank(values, ZeroRule::drop, 0)->p_above, 0.070741060741396702);
}

TEST(Wilcoxon, OneDifferenceProvesNothing) {
  EXPECT_EQ(signed_rank(std::vector<double>{2.5})->p, 1.0);
}

TEST(Wilcoxon, OnlyZerosHaveNoTest) {
  EXPECT_FALSE(signed_rank(std::vector<double>{0, 0, 0}));
  EXPECT_FALSE(signed_rank(std::vector<double>{0, 0, 0}, ZeroRule::pratt));
  EXPECT_FALSE(signed_rank(std::vector<double>{}));
}

TEST(Wilcoxon, BalancedDifferencesAreAsLikelyAsCanBe) {
  const SignedRankTest test = signed_rank(std::vector<double>{1, -1, 2, -2}).value();
  EXPECT_EQ(test.p, 1.0);
  EXPECT_EQ(test.rank_biserial, 0.0);
}

}  // namespace
}  // namespace foveola::analysis
