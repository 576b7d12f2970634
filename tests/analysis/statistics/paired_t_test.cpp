#include "analysis/statistics/paired_t.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "tests/analysis/golden.h"

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(PairedT, TestsIntervalsAndEffectSizesAreThoseOfR) {
  const auto golden = golden_inference();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".d_z")) {
      continue;
    }
    SCOPED_TRACE(name);
    const TTest test = paired_t(golden_column(matrix, 0), golden_column(matrix, 1)).value();
    EXPECT_EQ(test.n, matrix.size());
    EXPECT_GOLDEN(test.t, golden.at(name + ".t"));
    EXPECT_GOLDEN(test.p, golden.at(name + ".p"));
    EXPECT_GOLDEN(test.d_z, golden.at(name + ".d_z"));
    EXPECT_GOLDEN(test.interval.low, golden.at(name + ".low"));
    EXPECT_GOLDEN(test.interval.high, golden.at(name + ".high"));
    ++compared;
  }
  EXPECT_EQ(compared, 10);
}

TEST(PairedT, RatiosAreThoseOfR) {
  const auto golden = golden_inference();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".ratio")) {
      continue;
    }
    SCOPED_TRACE(name);
    const RatioTest test =
        paired_ratio_t(golden_column(matrix, 0), golden_column(matrix, 1)).value();
    EXPECT_GOLDEN(test.ratio, golden.at(name + ".ratio"));
    EXPECT_GOLDEN(test.interval.low, golden.at(name + ".ratio_low"));
    EXPECT_GOLDEN(test.interval.high, golden.at(name + ".ratio_high"));
    // Values around 1e9 lose digits when their logarithms are taken, in R too.
    if (name != "offset") {
      EXPECT_GOLDEN(test.logs.p, golden.at(name + ".ratio_p"));
    }
    ++compared;
  }
  EXPECT_GE(compared, 6);
}

TEST(PairedT, WhatDoesNotVaryHasNoT) {
  EXPECT_FALSE(paired_t(std::vector<double>{3, 4, 5}, std::vector<double>{1, 2, 3}));
  EXPECT_FALSE(paired_t(std::vector<double>{3}, std::vector<double>{1}));
  EXPECT_FALSE(paired_t(std::vector<double>{}, std::vector<double>{}));
}

TEST(PairedT, ARatioTurnsOverWithItsSides) {
  const std::vector<double> a = {1.5, 2.5, 9, 4};
  const std::vector<double> b = {7, 5, 12, 4.5};
  const RatioTest forward = paired_ratio_t(a, b).value();
  const RatioTest backward = paired_ratio_t(b, a).value();
  EXPECT_DOUBLE_EQ(forward.ratio, 1.0 / backward.ratio);
  EXPECT_DOUBLE_EQ(forward.interval.low, 1.0 / backward.interval.high);
  EXPECT_DOUBLE_EQ(forward.logs.p, backward.logs.p);
}

TEST(PairedT, UnitsDoNotMatterToRatios) {
  const std::vector<double> seconds = {1.5, 2.5, 9, 4};
  const std::vector<double> baseline = {7, 5, 12, 4.5};
  std::vector<double> ms = seconds;
  std::vector<double> baseline_ms = baseline;
  for (std::size_t i = 0; i < ms.size(); ++i) {
    ms[i] *= 1000.0;
    baseline_ms[i] *= 1000.0;
  }
  EXPECT_GOLDEN(paired_ratio_t(ms, baseline_ms)->logs.p, paired_ratio_t(seconds, baseline)->logs.p);
}

TEST(PairedT, ATimeWithoutALogarithmIsNamed) {
  EXPECT_THAT(
      [] {
        (void)paired_ratio_t(std::vector<double>{1, 0}, std::vector<double>{1, 2});
      },
      ThrowsMessage<Error>(HasSubstr("value 2 of 2")));
}

}  // namespace
}  // namespace foveola::analysis
