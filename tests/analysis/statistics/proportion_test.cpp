#include <utility>

#include "analysis/statistics/distributions.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

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

}  // namespace
}  // namespace foveola::analysis
