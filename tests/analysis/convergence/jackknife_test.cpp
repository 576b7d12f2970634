#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/convergence/error_curve.h"

namespace foveola::analysis {
namespace {

constexpr std::array values = {1.0, 4.0, 2.0, 8.0, 3.0};

std::vector<double> picked(std::span<const std::size_t> kept) {
  std::vector<double> result;
  for (const std::size_t i : kept) {
    result.push_back(values[i]);
  }
  return result;
}

// The jackknife of a mean is the classical interval (Efron and Tibshirani 1993, eq. 11.7).
TEST(Jackknife, OfAMeanIsStudentsInterval) {
  const auto estimate = jackknife(
      values.size(), [](std::span<const std::size_t> kept) { return mean(picked(kept)); });
  const auto expected = mean_estimate(values);
  ASSERT_TRUE(estimate && estimate->interval);
  EXPECT_EQ(estimate->n, 5U);
  EXPECT_NEAR(estimate->value, 3.6, 1e-12);
  EXPECT_NEAR(estimate->interval->low, expected->interval->low, 1e-9);
  EXPECT_NEAR(estimate->interval->high, expected->interval->high, 1e-9);
}

TEST(Jackknife, OfARatioIsOnItsLogarithm) {
  const auto estimate = jackknife_ratio(values.size(), [](std::span<const std::size_t> kept) {
    return std::optional(geometric_mean(picked(kept))->value);
  });
  const auto expected = geometric_mean(values);
  ASSERT_TRUE(estimate && estimate->interval);
  EXPECT_NEAR(estimate->value, expected->value, 1e-12);
  EXPECT_NEAR(estimate->interval->low, expected->interval->low, 1e-9);
  EXPECT_NEAR(estimate->interval->high, expected->interval->high, 1e-9);
}

TEST(Jackknife, HasNoIntervalOfOneRepetitionOrAPartialStatistic) {
  const auto one = jackknife(1, [](auto) { return std::optional(2.0); });
  ASSERT_TRUE(one);
  EXPECT_FALSE(one->interval);
  const auto partial = jackknife(3, [](std::span<const std::size_t> kept) {
    return kept.size() == 3 || kept[0] == 0 ? std::optional(2.0) : std::nullopt;
  });
  ASSERT_TRUE(partial);
  EXPECT_FALSE(partial->interval);
}

TEST(Jackknife, IsEmptyWithoutAValue) {
  EXPECT_FALSE(jackknife(3, [](auto) { return std::optional<double>(); }));
  EXPECT_FALSE(jackknife(0, [](auto) { return std::optional(1.0); }));
}

}  // namespace
}  // namespace foveola::analysis
