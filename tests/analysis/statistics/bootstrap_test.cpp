#include "analysis/statistics/bootstrap.h"

#include <numeric>

#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(Bootstrap, IntervalsFromGivenReplicatesAreThoseOfR) {
  const auto golden = golden_inference();
  const auto matrices = golden_matrices();
  const std::vector<double> values = golden_column(matrices.at("bootstrap"), 0);
  const std::vector<double> replicates = golden_column(matrices.at("bootstrap_replicates"), 0);
  ASSERT_EQ(replicates.size(), 999U);
  std::vector<double> jackknife;
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  for (const double value : values) {
    jackknife.push_back((sum - value) / 15.0);
  }
  const double observed = sum / 16.0;
  for (const int confidence : {90, 95}) {
    const Interval interval =
        bca_from_replicates(observed, replicates, jackknife, confidence / 100.0).value();
    EXPECT_GOLDEN(interval.low, golden.at("bootstrap.low_" + std::to_string(confidence)));
    EXPECT_GOLDEN(interval.high, golden.at("bootstrap.high_" + std::to_string(confidence)));
  }
}

const std::vector<double> times = {3.1, 4.7, 2.2, 8.9, 5.0, 6.4, 3.3, 12.5, 4.1, 7.7};

TEST(Bootstrap, TheSameSeedGivesTheSameInterval) {
  const Interval first = bca_geometric_mean(times, {.seed = 7}).value();
  const Interval again = bca_geometric_mean(times, {.seed = 7}).value();
  EXPECT_EQ(first.low, again.low);
  EXPECT_EQ(first.high, again.high);
  const Interval other = bca_geometric_mean(times, {.seed = 8}).value();
  EXPECT_NE(first.low, other.low);
  EXPECT_NEAR(first.low, other.low, 0.1);
}

TEST(Bootstrap, IsNearTheTIntervalOfManyValues) {
  std::vector<double> many;
  for (int copy = 0; copy < 30; ++copy) {
    many.insert(many.end(), times.begin(), times.end());
  }
  const Interval interval = bca_geometric_mean(many).value();
  const Estimate estimate = geometric_mean(many).value();
  EXPECT_NEAR(interval.low, estimate.interval->low, 0.05);
  EXPECT_NEAR(interval.high, estimate.interval->high, 0.05);
}

TEST(Bootstrap, ConstantOrFewValuesHaveNoInterval) {
  EXPECT_FALSE(bca_geometric_mean(std::vector<double>(16, 2.0)));
  const std::span<const double> few = std::span(times).first(min_for_bca - 1);
  EXPECT_FALSE(bca_geometric_mean(few));
  EXPECT_TRUE(bca_geometric_mean(std::span(times).first(min_for_bca)));
  EXPECT_FALSE(bca_geometric_mean(std::vector<double>{2.0, 3.0}));
  EXPECT_FALSE(bca_geometric_mean(std::vector<double>{}));
}

}  // namespace
}  // namespace foveola::analysis
