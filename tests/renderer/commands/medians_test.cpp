#include <numeric>

#include <gtest/gtest.h>

#include "renderer/commands/bench_facts.h"

namespace foveola {
namespace {

/// 1, 2, ... count, so that a value is its place.
std::vector<double> places(int count) {
  std::vector<double> values(static_cast<std::size_t>(count));
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

TEST(Medians, AreInTheMiddle) {
  EXPECT_EQ(median_of({3.0}).value, 3.0);
  EXPECT_EQ(median_of({5.0, 1.0, 2.0}).value, 2.0);
  EXPECT_EQ(median_of({5.0, 1.0, 4.0, 2.0}).value, 4.0);
}

// The places are those of R's qbinom(0.025, n, 0.5).
TEST(Medians, LieBetweenTheValuesOfABinomialInterval) {
  for (const auto& [count, low] :
       std::vector<std::pair<int, double>>{{6, 1.0}, {8, 1.0}, {9, 2.0}, {20, 6.0}, {31, 10.0}}) {
    const Median median = median_of(places(count));
    ASSERT_TRUE(median.interval) << count;
    EXPECT_EQ(median.interval->first, low) << count;
    EXPECT_EQ(median.interval->second, count + 1 - low) << count;
  }
}

TEST(Medians, OfFiveSayTooLittle) {
  EXPECT_FALSE(median_of(places(5)).interval);
  EXPECT_TRUE(json_of(median_of(places(5)))["low"].is_null());
}

TEST(Medians, TakeTheirIntervalsAlong) {
  const Median doubled = median_of(places(9)) * 2.0;
  EXPECT_EQ(doubled.value, 10.0);
  EXPECT_EQ(doubled.interval, std::pair(4.0, 16.0));
  const Median rate = 16.0 / median_of(places(9));
  EXPECT_EQ(rate.value, 16.0 / 5.0);
  EXPECT_EQ(rate.interval, std::pair(2.0, 8.0)) << "what takes longest is slowest";
  EXPECT_EQ(json_of(rate)["high"], 8.0);
}

}  // namespace
}  // namespace foveola
