#include "analysis/statistics/censored_mean.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/statistics/paired_t.h"
#include "tests/analysis/golden.h"

namespace foveola::analysis {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<BoundedValue> bounded(const GoldenMatrix& matrix) {
  std::vector<BoundedValue> values;
  for (const auto& row : matrix) {
    values.push_back({row[0].value_or(-infinity), row[1].value_or(infinity)});
  }
  return values;
}

TEST(CensoredMean, IsThatOfR) {
  const auto golden = golden_inference();
  for (const char* name : {"uncensored", "one_below", "some_above", "both_sides", "mostly"}) {
    SCOPED_TRACE(name);
    const std::string key = std::string(name) + ".";
    const CensoredMean found = censored_mean(bounded(golden_matrices().at(name))).value();
    EXPECT_EQ(static_cast<double>(found.n), golden.at(key + "n"));
    EXPECT_GOLDEN(found.mean, golden.at(key + "mean"));
    EXPECT_GOLDEN(found.standard_deviation, golden.at(key + "standard_deviation"));
    EXPECT_GOLDEN(found.standard_error, golden.at(key + "standard_error"));
    EXPECT_GOLDEN(found.interval.low, golden.at(key + "low"));
    EXPECT_GOLDEN(found.interval.high, golden.at(key + "high"));
    EXPECT_GOLDEN(found.p, golden.at(key + "p"));
  }
}

TEST(CensoredMean, WithoutCensoringItIsTheTTest) {
  const std::vector<double> values = {-2.0, -1.5, -2.75, -0.25, -3.0};
  std::vector<BoundedValue> exact;
  for (const double value : values) {
    exact.push_back(BoundedValue::exactly(value));
  }
  const CensoredMean found = censored_mean(exact).value();
  const TTest test = one_sample_t(values).value();
  EXPECT_EQ(found.censored, 0U);
  EXPECT_GOLDEN(found.mean, test.mean);
  EXPECT_GOLDEN(found.standard_deviation, test.standard_deviation);
  EXPECT_GOLDEN(found.interval.low, test.interval.low);
  EXPECT_GOLDEN(found.t, test.t);
  EXPECT_GOLDEN(found.p, test.p);
}

TEST(CensoredMean, ABoundPullsTheMeanItsWay) {
  std::vector<BoundedValue> values;
  for (const double value : {1.0, 2.0, 3.0, 4.0, 3.5}) {
    values.push_back(BoundedValue::exactly(value));
  }
  const double measured = censored_mean(values)->mean;
  values.push_back({5.0, infinity});
  const CensoredMean found = censored_mean(values).value();
  EXPECT_GT(found.mean, measured);
  EXPECT_EQ(found.censored, 1U);
  // As if the time had been known to be exactly the bound: less than what lies beyond it.
  values.back() = BoundedValue::exactly(5.0);
  EXPECT_GT(found.mean, censored_mean(values)->mean);
}

TEST(CensoredMean, WhatSaysNothingIsLeftOutAndCounted) {
  const std::vector<BoundedValue> values = {BoundedValue::exactly(1.0), BoundedValue{},
                                            BoundedValue::exactly(3.0), BoundedValue{}};
  const CensoredMean found = censored_mean(values).value();
  EXPECT_EQ(found.n, 2U);
  EXPECT_EQ(found.unknown, 2U);
  EXPECT_GOLDEN(found.mean, 2.0);
}

TEST(CensoredMean, ABoundFarAwayFromTheValuesStillHasAPeak) {
  std::vector<BoundedValue> values;
  for (const double value : {0.0, 0.001, -0.001, 0.0005}) {
    values.push_back(BoundedValue::exactly(value));
  }
  values.push_back({100.0, infinity});
  const CensoredMean found = censored_mean(values).value();
  EXPECT_GT(found.mean, 0.0);
  EXPECT_TRUE(std::isfinite(found.standard_error));
}

TEST(CensoredMean, NeedsMeasuredValuesThatDiffer) {
  EXPECT_FALSE(censored_mean(std::vector<BoundedValue>{}));
  EXPECT_FALSE(censored_mean(std::vector<BoundedValue>{{1.0, infinity}, {2.0, infinity}}));
  EXPECT_FALSE(censored_mean(
      std::vector<BoundedValue>{BoundedValue::exactly(1.0), BoundedValue::exactly(1.0)}));
}

TEST(CensoredMean, DifferencesOfBoundsAreBounds) {
  const BoundedValue timed_out{3.0, infinity};
  const BoundedValue measured = BoundedValue::exactly(1.0);
  EXPECT_EQ(difference(measured, timed_out).high, -2.0);
  EXPECT_EQ(difference(measured, timed_out).low, -infinity);
  EXPECT_EQ(difference(timed_out, measured).low, 2.0);
  EXPECT_TRUE(difference(timed_out, timed_out).is_unknown());
  EXPECT_TRUE(difference(measured, measured).is_exact());
}

}  // namespace
}  // namespace foveola::analysis
