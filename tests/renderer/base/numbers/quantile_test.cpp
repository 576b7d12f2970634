#include "renderer/base/numbers/quantile.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace foveola {
namespace {

constexpr std::array<double, 5> odd{1.0, 2.0, 4.0, 8.0, 16.0};
constexpr std::array<double, 4> even{1.0, 2.0, 4.0, 8.0};

// As R's quantile(x, p, type = 1) has them.
TEST(Quantile, IsTheLeastThatEnoughValuesDoNotExceed) {
  EXPECT_EQ(quantile(odd, 0.0), 1.0);
  EXPECT_EQ(quantile(odd, 0.2), 1.0);
  EXPECT_EQ(quantile(odd, 0.21), 2.0);
  EXPECT_EQ(quantile(odd, 0.5), 4.0);
  EXPECT_EQ(quantile(odd, 0.95), 16.0);
  EXPECT_EQ(quantile(odd, 1.0), 16.0);
  EXPECT_EQ(quantile(even, 0.5), 2.0);
  EXPECT_EQ(quantile(even, 0.51), 4.0);
}

TEST(Median, IsTheMeanOfTheTwoInTheMiddle) {
  EXPECT_EQ(median(std::vector{3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median(std::vector{4.0, 1.0, 2.0, 8.0}), 3.0);
  EXPECT_EQ(median({}), std::nullopt);
}

TEST(UpperMedian, IsTheUpperOfTwo) {
  EXPECT_EQ(upper_median({16.0, 1.0, 4.0, 2.0, 8.0}), 4.0);
  EXPECT_EQ(upper_median({8.0, 1.0, 4.0, 2.0}), 4.0);
  EXPECT_EQ(upper_median({}), std::nullopt);
}

}  // namespace
}  // namespace foveola
