#include "analysis/statistics/proportion.h"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/golden.h"

namespace foveola::analysis {
namespace {

TEST(Proportion, IntervalsAreThoseOfR) {
  const auto golden = golden_inference();
  const std::pair<std::size_t, std::size_t> cases[] = {
      {0, 10}, {10, 10}, {3, 16}, {200, 4000}, {1, 1}};
  for (const auto& [successes, trials] : cases) {
    const std::string name =
        "proportion_" + std::to_string(successes) + "_" + std::to_string(trials) + ".";
    SCOPED_TRACE(name);
    const Interval interval = clopper_pearson(successes, trials);
    EXPECT_GOLDEN(interval.low, golden.at(name + "low"));
    EXPECT_GOLDEN(interval.high, golden.at(name + "high"));
  }
}

TEST(Proportion, MissesMirrorSuccesses) {
  const Interval hits = clopper_pearson(3, 20);
  const Interval misses = clopper_pearson(17, 20);
  EXPECT_DOUBLE_EQ(hits.low, 1.0 - misses.high);
  EXPECT_DOUBLE_EQ(hits.high, 1.0 - misses.low);
}

}  // namespace
}  // namespace foveola::analysis
