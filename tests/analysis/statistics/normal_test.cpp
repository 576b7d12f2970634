#include "analysis/statistics/distributions.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(Normal, TailsAreThoseOfR) {
  const auto golden = golden_inference();
  EXPECT_GOLDEN(normal_two_sided(30.0), golden.at("tails.normal_30"));
  EXPECT_GOLDEN(normal_two_sided(-37.0), golden.at("tails.normal_37"));
  EXPECT_EQ(normal_two_sided(0.0), 1.0);
}

TEST(Normal, QuantilesTurnProbabilitiesBack) {
  for (const double probability : {1e-300, 1e-10, 0.025, 0.5, 0.975}) {
    EXPECT_NEAR(normal_cdf(normal_quantile(probability)) / probability, 1.0, 1e-12);
  }
  EXPECT_NEAR(normal_two_sided_quantile(0.95), 1.959963984540054, 1e-15);
  EXPECT_NEAR(normal_quantile(0.025), -1.959963984540054, 1e-15);
}

}  // namespace
}  // namespace foveola::analysis
