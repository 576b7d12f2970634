
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "analysis/statistics/models/crossed_model.h"
#include "analysis/statistics/paired_t.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/pairs.h"

namespace foveola::analysis {
namespace {

EquivalenceTest of_mean(const std::vector<double>& values, double margin) {
  const TTest test = test_mean(values).value();
  return test_equivalence(test.mean, test.standard_error(), test.degrees_of_freedom, margin);
}

TEST(Equivalence, TwoOneSidedTestsAreThoseOfR) {
  const auto golden = golden_inference();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".margin")) {
      continue;
    }
    SCOPED_TRACE(name);
    const std::vector<double> values =
        differences(golden_column(matrix, 0), golden_column(matrix, 1));
    const EquivalenceTest test = of_mean(values, golden.at(name + ".margin"));
    EXPECT_GOLDEN(test.p_above_low, golden.at(name + ".p_above_low"));
    EXPECT_GOLDEN(test.p_below_high, golden.at(name + ".p_below_high"));
    EXPECT_EQ(test.p, std::max(test.p_above_low, test.p_below_high));
    EXPECT_GOLDEN(test.interval->low, golden.at(name + ".low_90"));
    EXPECT_GOLDEN(test.interval->high, golden.at(name + ".high_90"));
    ++compared;
  }
  EXPECT_EQ(compared, 10);
}

// By R: pt((0.05 - log(1.25)) / 0.06, 7.5), exp(0.05 + c(-1, 1) * qt(0.95, 7.5) * 0.06).
TEST(Equivalence, DegreesOfFreedomNeedNotBeWhole) {
  const EquivalenceTest test = test_equivalence(0.05, 0.06, 7.5, std::log(1.25));
  EXPECT_GOLDEN(test.p, 0.01088623171881453);
  EXPECT_GOLDEN(std::exp(test.interval->low), 0.9393709322541185);
  EXPECT_GOLDEN(std::exp(test.interval->high), 1.1765010818715402);
}

TEST(Equivalence, TheIntervalLiesWithinTheMarginsExactlyWhenTheTestSaysSo) {
  const double high = test_equivalence(0.1, 0.2, 6.0, 1.0).interval->high;
  EXPECT_LT(test_equivalence(0.1, 0.2, 6.0, high + 1e-9).p, 0.05);
  EXPECT_GT(test_equivalence(0.1, 0.2, 6.0, high - 1e-9).p, 0.05);
}

TEST(Equivalence, OfTheCrossedModelItIsAsCertainAsItsInterval) {
  const RepeatedMeasures data =
      complete_participants(golden_matrices("models_samples.csv").at("interior_16x5"));
  const CrossedModel model = crossed_model(data).value();
  const EquivalenceTest test = test_equivalence(model.mean, model.test->standard_error,
                                                model.test->degrees_of_freedom, std::log(2.0));
  const Interval ninety = crossed_model(data, 0.9)->test->interval;
  EXPECT_DOUBLE_EQ(test.interval->low, ninety.low);
  EXPECT_DOUBLE_EQ(test.interval->high, ninety.high);
}

// By R's wilcox.test(x, mu = -+margin, alternative = "greater" and "less", exact = TRUE), and its
// interval with conf.level = 0.9; with ties and zeros by the enumeration of all signs.
TEST(Equivalence, ByRanksIsThatOfR) {
  const std::vector<double> plain = {0.31, -0.22, 0.54, 0.13, 0.41, -0.17, 0.28, 0.05};
  const EquivalenceTest within = test_equivalence_by_ranks(plain, 0.6).value();
  EXPECT_EQ(within.p_above_low, 0.00390625);
  EXPECT_EQ(within.p_below_high, 0.00390625);
  EXPECT_DOUBLE_EQ(within.interval->low, -0.045);
  EXPECT_DOUBLE_EQ(within.interval->high, 0.36);
  EXPECT_EQ(test_equivalence_by_ranks(plain, 0.3)->p, 0.125);
  const std::vector<double> tied = {0.2, -0.2, 0.4, 0.0, 0.2, -0.4, 0.6, 0.2, 0.0, 0.2};
  EXPECT_EQ(test_equivalence_by_ranks(tied, 0.5)->p_above_low, 1.0 / 1024.0);
  EXPECT_EQ(test_equivalence_by_ranks(tied, 0.5)->p, 3.0 / 1024.0);
  EXPECT_EQ(test_equivalence_by_ranks(tied, 0.4)->p, 6.0 / 512.0);
  EXPECT_EQ(test_equivalence_by_ranks(std::vector<double>{0.5, 0.5}, 0.5)->p, 1.0);
  EXPECT_FALSE(test_equivalence_by_ranks(std::vector<double>{0.1}, 1.0)->interval);
  EXPECT_FALSE(test_equivalence_by_ranks({}, 1.0));
}

}  // namespace
}  // namespace foveola::analysis
