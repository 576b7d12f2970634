#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/statistics/distributions.h"
#include "analysis/statistics/logarithms.h"

namespace foveola::analysis {
namespace {

using Values = std::vector<std::optional<double>>;

TEST(LogOfMeans, OfOneMeanHasTheRelativeErrorOfTheMean) {
  // Mean 4, standard deviation 2, standard error 2 / sqrt(3); t(2) is 4.302653.
  const LogOfMeans mean = log_of_mean(Values{2.0, {}, 4.0, 6.0}).value();
  EXPECT_DOUBLE_EQ(mean.value, std::log(4.0));
  ASSERT_EQ(mean.influences.size(), 4U);
  EXPECT_DOUBLE_EQ(mean.influences[0].value(), -2.0 / (3.0 * 4.0));
  EXPECT_FALSE(mean.influences[1]);
  const Estimate estimate = estimate_of(mean);
  EXPECT_EQ(estimate.n, 3U);
  EXPECT_DOUBLE_EQ(estimate.value, 4.0);
  const double half_width = 4.302653 * 2.0 / std::sqrt(3.0) / 4.0;
  EXPECT_NEAR(estimate.interval->low, 4.0 * std::exp(-half_width), 1e-5);
  EXPECT_NEAR(estimate.interval->high, 4.0 * std::exp(half_width), 1e-4);
}

TEST(LogOfMeans, ARatioTakesEachParticipantsTwoValuesTogether) {
  // Means 6 and 12; the influences are (y - 6) / (3 * 6) - (x - 12) / (3 * 12).
  const LogOfMeans y = log_of_mean(Values{4.0, 6.0, 8.0}).value();
  const LogOfMeans x = log_of_mean(Values{6.0, 12.0, 18.0}).value();
  const LogOfMeans ratio = log_of_ratio(y, x);
  EXPECT_DOUBLE_EQ(ratio.value, std::log(0.5));
  const double first = -2.0 / 18.0 + 6.0 / 36.0;
  EXPECT_DOUBLE_EQ(ratio.influences[0].value(), first);
  EXPECT_NEAR(ratio.influences[1].value(), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(ratio.influences[2].value(), -first);
  const Estimate estimate = estimate_of(ratio);
  const double s = std::sqrt(3.0 / 2.0 * 2.0 * first * first);
  EXPECT_NEAR(std::log(estimate.interval->high) - std::log(0.5), student_t_quantile(0.95, 2.0) * s,
              1e-12);
}

TEST(LogOfMeans, APerfectlyProportionalRatioHasNoInterval) {
  const LogOfMeans y = log_of_mean(Values{1.0, 2.0, 3.0}).value();
  const LogOfMeans x = log_of_mean(Values{10.0, 20.0, 30.0}).value();
  const Estimate estimate = estimate_of(log_of_ratio(y, x));
  EXPECT_DOUBLE_EQ(estimate.value, 0.1);
  EXPECT_FALSE(estimate.interval);
}

TEST(LogOfMeans, ParticipantsCountWhoHaveAnyOfTheValues) {
  const LogOfMeans y = log_of_mean(Values{1.0, 3.0, {}, {}}).value();
  const LogOfMeans x = log_of_mean(Values{{}, 5.0, 7.0, {}}).value();
  EXPECT_EQ(estimate_of(log_of_ratio(y, x)).n, 3U);
  EXPECT_DOUBLE_EQ(log_of_ratio(y, x).influences[2].value(), -1.0 / (2.0 * 6.0));
}

TEST(LogOfMeans, AGeometricMeanOfEqualScenesIsOneOfThem) {
  const LogOfMeans scene = log_of_mean(Values{2.0, 4.0, 6.0}).value();
  const std::vector<LogOfMeans> scenes = {scene, scene, scene};
  const Estimate one = estimate_of(scene);
  const Estimate all = estimate_of(log_of_geometric_mean(scenes));
  EXPECT_NEAR(all.value, one.value, 1e-12);
  EXPECT_NEAR(all.interval->low, one.interval->low, 1e-12);
  EXPECT_NEAR(all.interval->high, one.interval->high, 1e-12);
}

TEST(LogOfMeans, AGeometricMeanIsOfTheMeans) {
  const std::vector<LogOfMeans> scenes = {log_of_mean(Values{1.0, 3.0}).value(),
                                          log_of_mean(Values{8.0, 8.0}).value()};
  const LogOfMeans all = log_of_geometric_mean(scenes);
  EXPECT_DOUBLE_EQ(std::exp(all.value), 4.0);
  EXPECT_DOUBLE_EQ(all.influences[0].value(), -0.5 / 4.0);
}

TEST(LogOfMeans, TooFewHaveNoIntervalAndNoneNoMean) {
  EXPECT_FALSE(log_of_mean(Values{{}, {}}));
  EXPECT_FALSE(log_of_mean(Values{}));
  const Estimate one = estimate_of(log_of_mean(Values{5.0}).value());
  EXPECT_DOUBLE_EQ(one.value, 5.0);
  EXPECT_FALSE(one.interval);
}

}  // namespace
}  // namespace foveola::analysis
