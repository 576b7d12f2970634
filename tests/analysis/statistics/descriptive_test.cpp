#include "analysis/statistics/descriptive.h"

#include <cmath>
#include <limits>
#include <map>

#include "renderer/base/error.h"
#include "renderer/base/numbers/quantile.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

/// The samples of one value per row.
std::map<std::string, std::vector<double>> single_samples() {
  std::map<std::string, std::vector<double>> samples;
  for (const CsvRow& row : golden_rows("statistics_samples.csv")) {
    if (row.at(2).empty()) {
      samples[row[0]].push_back(std::stod(row[1]));
    }
  }
  return samples;
}

TEST(Descriptive, MomentsAndMediansAreThoseOfR) {
  const auto golden = golden_statistics();
  for (const auto& [name, values] : single_samples()) {
    SCOPED_TRACE(name);
    const Description description = describe(values);
    EXPECT_EQ(static_cast<double>(description.n), golden.at(name + ".n"));
    EXPECT_GOLDEN(description.mean.value(), golden.at(name + ".mean"));
    EXPECT_GOLDEN(description.standard_deviation.value(), golden.at(name + ".standard_deviation"));
    EXPECT_GOLDEN(description.median.value(), golden.at(name + ".median"));
  }
}

TEST(Descriptive, GeometricMeansAndIntervalsAreThoseOfR) {
  const auto golden = golden_statistics();
  for (const auto& [name, values] : single_samples()) {
    SCOPED_TRACE(name);
    const Estimate estimate = geometric_mean(values).value();
    EXPECT_GOLDEN(estimate.value, golden.at(name + ".geometric_mean"));
    ASSERT_EQ(estimate.interval.has_value(), golden.contains(name + ".geometric_mean_low"));
    if (estimate.interval) {
      EXPECT_GOLDEN(estimate.interval->low, golden.at(name + ".geometric_mean_low"));
      EXPECT_GOLDEN(estimate.interval->high, golden.at(name + ".geometric_mean_high"));
    }
  }
}

TEST(Descriptive, SaurosTaskTimesHaveHisGeometricMean) {
  const std::vector<double> seconds = {55, 65, 75, 62, 45, 135};
  const Estimate estimate = geometric_mean(seconds).value();
  EXPECT_NEAR(estimate.value, 68.24, 0.005);
  EXPECT_NEAR(estimate.interval->low, 46.01, 0.005);
  EXPECT_NEAR(estimate.interval->high, 101.22, 0.005);
  EXPECT_EQ(estimate.n, 6U);
}

TEST(Descriptive, ACommonOffsetLeavesTheDeviation) {
  const std::vector<double> plain = {0.0, 0.25, 0.5, 1.0};
  std::vector<double> shifted = plain;
  for (double& value : shifted) {
    value += 1e9;
  }
  EXPECT_DOUBLE_EQ(mean(shifted).value(), 1e9 + 0.4375);
  EXPECT_DOUBLE_EQ(standard_deviation(shifted).value(), standard_deviation(plain).value());
}

TEST(Descriptive, EmptySamplesHaveNothing) {
  const std::vector<double> none;
  EXPECT_FALSE(mean(none));
  EXPECT_FALSE(standard_deviation(none));
  EXPECT_FALSE(median(none));
  EXPECT_FALSE(mean_estimate(none));
  EXPECT_FALSE(geometric_mean(none));
}

TEST(Descriptive, OneValueHasAMeanButNoSpread) {
  const std::vector<double> one = {4.0};
  EXPECT_EQ(mean(one), 4.0);
  EXPECT_EQ(median(one), 4.0);
  EXPECT_FALSE(standard_deviation(one));
  EXPECT_DOUBLE_EQ(geometric_mean(one)->value, 4.0);
  EXPECT_FALSE(geometric_mean(one)->interval);
}

TEST(Descriptive, ValuesThatAreAllEqualHaveAMeanAndNoInterval) {
  const std::vector<double> equal(7, 0.1);
  EXPECT_FALSE(varies(equal));
  EXPECT_DOUBLE_EQ(mean_estimate(equal)->value, 0.1);
  EXPECT_FALSE(mean_estimate(equal)->interval);
  EXPECT_DOUBLE_EQ(geometric_mean(equal)->value, 0.1);
  EXPECT_FALSE(geometric_mean(equal)->interval);
  EXPECT_TRUE(varies(std::vector<double>{1e9, 1e9 + 1e-4}));
  EXPECT_TRUE(varies(std::vector<double>{0.0, 1e-300}));
}

TEST(Descriptive, ValuesThatDifferInTheirRoundingAloneAreEqual) {
  // Everybody takes half the time, in different units.
  const std::vector<double> logs = {std::log(50.0) - std::log(100.0),
                                    std::log(5.0) - std::log(10.0), std::log(0.35) - std::log(0.7)};
  EXPECT_FALSE(varies(logs));
  EXPECT_NEAR(geometric_mean_of_logs(logs)->value, 0.5, 1e-15);
  EXPECT_FALSE(geometric_mean_of_logs(logs)->interval);
  // Ratios near 1, whose logarithms have lost most digits.
  const std::vector<double> small = {std::log(101.0) - std::log(100.0),
                                     std::log(10100.0) - std::log(10000.0)};
  ASSERT_NE(small[0], small[1]);
  EXPECT_NEAR(geometric_mean_of_logs(small)->value, 1.01, 1e-14);
  EXPECT_FALSE(geometric_mean_of_logs(small)->interval);
}

TEST(Descriptive, GeometricMeanNamesTheValueWithoutLogarithm) {
  const auto of = [](std::vector<double> values) {
    return [values = std::move(values)] { (void)geometric_mean(values); };
  };
  EXPECT_THAT(of({1.0, 2.0, 0.0}), ThrowsMessage<Error>(AllOf(HasSubstr("value 3 of 3"),
                                                              HasSubstr("0 is not above zero"))));
  EXPECT_THAT(of({-1.5, 2.0}), ThrowsMessage<Error>(AllOf(HasSubstr("value 1 of 2"),
                                                          HasSubstr("-1.5 is not above zero"))));
  EXPECT_THAT(of({1.0, std::numeric_limits<double>::quiet_NaN()}),
              ThrowsMessage<Error>(HasSubstr("value 2 of 2")));
}

TEST(Descriptive, AMeansIntervalFollowsFromWhatATablePrints) {
  // 41.8 -+ t(15) 9.8 / 4 with t(15) = 2.131450; of the same values, the same as from them.
  const Estimate printed =
      mean_estimate(Description{.n = 16, .mean = 41.8, .standard_deviation = 9.8, .median = {}})
          .value();
  EXPECT_NEAR(printed.interval->low, 36.57795, 1e-5);
  EXPECT_NEAR(printed.interval->high, 47.02205, 1e-5);
  const std::vector<double> values = {1.0, 2.0, 4.5};
  EXPECT_EQ(mean_estimate(describe(values))->interval->low, mean_estimate(values)->interval->low);
  EXPECT_FALSE(mean_estimate(Description{}));
  EXPECT_FALSE(mean_estimate(describe(std::vector<double>{3.0}))->interval);
  EXPECT_FALSE(mean_estimate(describe(std::vector<double>{3.0, 3.0}))->interval);
}

}  // namespace
}  // namespace foveola::analysis
