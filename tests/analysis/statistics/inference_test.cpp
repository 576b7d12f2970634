#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "analysis/statistics/correlation.h"
#include "tests/analysis/golden.h"

namespace foveola::analysis {
namespace {

struct Pairs {
  std::vector<double> x;
  std::vector<double> y;
};

std::map<std::string, Pairs> paired_samples() {
  std::map<std::string, Pairs> samples;
  for (const CsvRow& row : golden_rows("statistics_samples.csv")) {
    if (!row.at(2).empty()) {
      samples[row[0]].x.push_back(std::stod(row[1]));
      samples[row[0]].y.push_back(std::stod(row[2]));
    }
  }
  return samples;
}

TEST(Inference, CorrelationsAreThoseOfR) {
  const auto golden = golden_statistics();
  for (const auto& [name, pairs] : paired_samples()) {
    SCOPED_TRACE(name);
    const Correlation correlation = pearson(pairs.x, pairs.y).value();
    EXPECT_EQ(static_cast<double>(correlation.n), golden.at(name + ".n"));
    EXPECT_GOLDEN(correlation.r, golden.at(name + ".r"));
    EXPECT_GOLDEN(correlation.t, golden.at(name + ".t"));
    EXPECT_GOLDEN(correlation.p, golden.at(name + ".p"));
    ASSERT_EQ(correlation.interval.has_value(), golden.contains(name + ".r_low"));
    if (correlation.interval) {
      EXPECT_GOLDEN(correlation.interval->low, golden.at(name + ".r_low"));
      EXPECT_GOLDEN(correlation.interval->high, golden.at(name + ".r_high"));
    }
  }
}

TEST(Inference, FewerThanThreePairsHaveNoCorrelation) {
  EXPECT_FALSE(pearson(std::vector<double>{}, std::vector<double>{}));
  EXPECT_FALSE(pearson(std::vector<double>{1, 2}, std::vector<double>{3, 5}));
}

TEST(Inference, ConstantValuesHaveNoCorrelation) {
  const std::vector<double> constant(5, 0.1);
  const std::vector<double> varying = {1, 2, 3, 5, 4};
  EXPECT_FALSE(pearson(constant, varying));
  EXPECT_FALSE(pearson(varying, constant));
}

TEST(Inference, APerfectCorrelationIsCertain) {
  const std::vector<double> x = {1, 2, 3, 4};
  const std::vector<double> falling = {-2, -4, -6, -8};
  const Correlation correlation = pearson(x, falling).value();
  EXPECT_DOUBLE_EQ(correlation.r, -1.0);
  EXPECT_LT(correlation.p, 1e-14);
  EXPECT_FALSE(std::isnan(correlation.interval->low));
  EXPECT_FALSE(std::isnan(correlation.interval->high));
}

TEST(Inference, HugeValuesDoNotOverflow) {
  const std::vector<double> x = {1, 2, 4, 3};
  std::vector<double> huge = {2.5, 2, 7, -1};
  const double r = pearson(x, huge)->r;
  for (double& value : huge) {
    value *= 1e300;
  }
  EXPECT_DOUBLE_EQ(pearson(x, huge)->r, r);
}

}  // namespace
}  // namespace foveola::analysis
