#include "analysis/statistics/equivalence.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/golden.h"
#include "tests/analysis/pairs.h"

namespace foveola::analysis {
namespace {

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
    const EquivalenceTest test = equivalence(values, golden.at(name + ".margin")).value();
    EXPECT_GOLDEN(test.p_above_low, golden.at(name + ".p_above_low"));
    EXPECT_GOLDEN(test.p_below_high, golden.at(name + ".p_below_high"));
    EXPECT_EQ(test.p, std::max(test.p_above_low, test.p_below_high));
    EXPECT_GOLDEN(test.interval.low, golden.at(name + ".low_90"));
    EXPECT_GOLDEN(test.interval.high, golden.at(name + ".high_90"));
    ++compared;
  }
  EXPECT_EQ(compared, 10);
}

TEST(Equivalence, TheIntervalLiesWithinTheMarginsExactlyWhenTheTestSaysSo) {
  const std::vector<double> values = {0.3, -0.2, 0.5, 0.1, 0.4, -0.1};
  const Interval interval = equivalence(values, 1.0)->interval;
  EXPECT_LT(equivalence(values, interval.high + 1e-9)->p, 0.05);
  EXPECT_GT(equivalence(values, interval.high - 1e-9)->p, 0.05);
}

TEST(Equivalence, RatiosAreTestedOnTheirLogarithms) {
  const std::vector<double> a = {1.0, 2.2, 2.9, 4.1};
  const std::vector<double> b = {1.1, 2.0, 3.0, 4.0};
  const double margin = std::log(1.25);
  const EquivalenceTest test = equivalence(log_ratios(a, b), margin).value();
  EXPECT_LT(test.interval.low, 0.0);
  EXPECT_GT(test.interval.high, 0.0);
  const EquivalenceTest swapped = equivalence(log_ratios(b, a), margin).value();
  EXPECT_DOUBLE_EQ(swapped.p_above_low, test.p_below_high);
  EXPECT_DOUBLE_EQ(swapped.interval.low, -test.interval.high);
}

TEST(Equivalence, OfTheCrossedModelItIsAsCertainAsItsInterval) {
  const RepeatedMeasures data =
      complete_participants(golden_matrices("models_samples.csv").at("interior_16x5"));
  const CrossedModel model = crossed_model(data).value();
  const EquivalenceTest test = equivalence(model, std::log(2.0)).value();
  const Interval ninety = crossed_model(data, 0.9)->test->interval;
  EXPECT_DOUBLE_EQ(test.interval.low, ninety.low);
  EXPECT_DOUBLE_EQ(test.interval.high, ninety.high);
  EXPECT_LT(equivalence(model, -ninety.low + 1e-9)->p, 0.05);
  EXPECT_GT(equivalence(model, -ninety.low - 1e-9)->p, 0.05);
  // Without differences between scenes it is that over participants.
  const RepeatedMeasures fixed =
      complete_participants(golden_matrices("models_samples.csv").at("no_scenes_12x5"));
  std::vector<double> means;
  for (std::size_t participant = 0; participant < fixed.participants; ++participant) {
    means.push_back(*mean(fixed.of(participant)));
  }
  EXPECT_GOLDEN(equivalence(crossed_model(fixed).value(), std::log(2.0))->p,
                equivalence(means, std::log(2.0))->p);
  EXPECT_FALSE(equivalence(crossed_model({2, 2, {0.1, 0.1, 0.1, 0.1}}).value(), 2.0));
}

TEST(Equivalence, WhatDoesNotVaryHasNoTest) {
  EXPECT_FALSE(equivalence(std::vector<double>{0.5, 0.5}, 1.0));
  EXPECT_FALSE(equivalence(std::vector<double>{0.5}, 1.0));
}

}  // namespace
}  // namespace foveola::analysis
