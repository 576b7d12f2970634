#include "renderer/base/numbers/exact_sum.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

double sum_of(const std::vector<double>& values) {
  ExactSum sum;
  for (const double value : values) {
    sum.add(value);
  }
  return sum.rounded();
}

TEST(ExactSum, OfNothingIsNothing) {
  EXPECT_EQ(sum_of({}), 0.0);
  EXPECT_EQ(sum_of({0.0, -0.0}), 0.0);
  EXPECT_EQ(sum_of({3.0, -3.0}), 0.0);
}

TEST(ExactSum, LosesNothingOnTheWay) {
  EXPECT_EQ(sum_of({1e100, 1.0, -1e100}), 1.0);
  EXPECT_EQ(sum_of(std::vector<double>(10, 0.1)), 1.0);
  EXPECT_EQ(sum_of({0x1p1023, 0x1p-1074, -0x1p1023}), 0x1p-1074);
}

TEST(ExactSum, OfSumsIsTheSumOfAll) {
  ExactSum left;
  ExactSum right;
  for (const double value : {1e100, 0.1, 0x1p-53}) {
    left.add(value);
  }
  for (const double value : {-1e100, 1.0}) {
    right.add(value);
  }
  left.add(right);
  EXPECT_EQ(left.rounded(), sum_of({1.0, 0.1, 0x1p-53}));
}

TEST(ExactSum, IsRoundedToTheNearestAndOfTwoToTheEvenOne) {
  EXPECT_EQ(sum_of({1.0, 0x1p-53}), 1.0);
  EXPECT_EQ(sum_of({1.0, 0x1p-53, 0x1p-106}), 1.0 + 0x1p-52);
  EXPECT_EQ(sum_of({1.0, 0x1p-53, -0x1p-106}), 1.0);
  EXPECT_EQ(sum_of({1.0 + 0x1p-52, 0x1p-53}), 1.0 + 0x1p-51);
  EXPECT_EQ(sum_of({1.0 + 0x1p-52, 0x1p-53, -0x1p-106}), 1.0 + 0x1p-52);
  EXPECT_EQ(sum_of({-1.0, -0x1p-53, -0x1p-106}), -1.0 - 0x1p-52);
}

using Integer = boost::multiprecision::cpp_int;

/// A double of at least 2^-400 as a whole number of 2^-500.
Integer exactly(double value) {
  int exponent = 0;
  const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  return Integer(digits) << (exponent - 53 + 500);
}

TEST(ExactSum, IsTheNearestDoubleInWhateverOrder) {
  Pcg32 random(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> values;
    Integer exact = 0;
    for (int i = 0; i < 50; ++i) {
      const auto digits = static_cast<double>(random.next()) - 0x1p31;
      values.push_back(std::ldexp(digits, static_cast<int>(random.next() % 190) - 200));
      exact += exactly(values.back());
    }
    const double sum = sum_of(values);
    for (const double neighbour : {std::nextafter(sum, -INFINITY), std::nextafter(sum, INFINITY)}) {
      EXPECT_LE(abs(exact - exactly(sum)), abs(exact - exactly(neighbour)));
    }
    std::ranges::sort(values);
    EXPECT_EQ(sum_of(values), sum);
    std::ranges::reverse(values);
    EXPECT_EQ(sum_of(values), sum);
  }
}

}  // namespace
}  // namespace foveola
