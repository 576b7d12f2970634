#include "analysis/statistics/paired_t.h"

#include "renderer/base/error.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/pairs.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(PairedT, TestsIntervalsAndEffectSizesAreThoseOfR) {
  const auto golden = golden_inference();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".d_z")) {
      continue;
    }
    SCOPED_TRACE(name);
    const TTest test =
        test_mean(differences(golden_column(matrix, 0), golden_column(matrix, 1))).value();
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
        test_ratio(log_ratios(golden_column(matrix, 0), golden_column(matrix, 1))).value();
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
  EXPECT_FALSE(test_mean(std::vector<double>{2, 2, 2}));
  EXPECT_FALSE(test_mean(std::vector<double>{2}));
  EXPECT_FALSE(test_mean(std::vector<double>{}));
  const std::vector<double> halves = log_ratios({50.0, 5.0, 0.35}, {100.0, 10.0, 0.7});
  EXPECT_FALSE(test_mean(halves));
  EXPECT_FALSE(test_ratio(halves));
  EXPECT_FALSE(test_ratio(log_ratios({101.0, 10100.0}, {100.0, 10000.0})));
}

}  // namespace
}  // namespace foveola::analysis
