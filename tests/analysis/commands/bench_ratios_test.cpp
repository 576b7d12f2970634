#include "analysis/commands/bench_ratios.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

BenchComparison compare(const std::string& before, const std::string& after) {
  return compare_benches(before, "before.json", after, "after.json");
}

TEST(BenchRatios, MatchByNameNotByPosition) {
  const BenchComparison comparison = compare(
      R"({"width": 8, "runs": [{"threads": 1, "seconds": 4, "rays": {"shadow": 10}},
                               {"threads": 2, "seconds": 2, "rays": {"shadow": 10}}]})",
      R"({"width": 8, "runs": [{"threads": 2, "seconds": 1, "rays": {"shadow": 20}},
                               {"threads": 1, "seconds": 3, "rays": {"shadow": 20}}]})");
  ASSERT_EQ(comparison.ratios.size(), 4U);
  EXPECT_EQ(comparison.ratios[0].figure, "runs[threads=1].seconds");
  EXPECT_DOUBLE_EQ(comparison.ratios[0].ratio, 0.75);
  EXPECT_FALSE(comparison.ratios[0].interval);
  EXPECT_EQ(comparison.ratios[1].figure, "runs[threads=1].rays.shadow");
  EXPECT_DOUBLE_EQ(comparison.ratios[1].ratio, 2.0);
  EXPECT_EQ(comparison.ratios[2].figure, "runs[threads=2].seconds");
  EXPECT_DOUBLE_EQ(comparison.ratios[2].ratio, 0.5);
  EXPECT_THAT(comparison.differing, IsEmpty());
  EXPECT_THAT(comparison.unmatched, IsEmpty());
}

// The logarithms' distances to their ends are ln 2 and ln 2, and ln 1.5 and ln 1.25: by hand.
TEST(BenchRatios, CombineIntervalsOnTheLogarithm) {
  const BenchComparison comparison =
      compare(R"({"costs": [{"scene": "a", "ratio": {"value": 2.0, "low": 1.6, "high": 4.0}}]})",
              R"({"costs": [{"scene": "a", "ratio": {"value": 6.0, "low": 3.0, "high": 9.0}}]})");
  ASSERT_EQ(comparison.ratios.size(), 1U);
  const BenchRatio& row = comparison.ratios[0];
  EXPECT_EQ(row.figure, "costs[scene=a].ratio");
  EXPECT_DOUBLE_EQ(row.ratio, 3.0);
  ASSERT_TRUE(row.interval);
  EXPECT_NEAR(row.interval->low, 3.0 * std::exp(-0.980258), 1e-5);
  EXPECT_NEAR(row.interval->high, 3.0 * std::exp(0.462812), 1e-5);
}

TEST(BenchRatios, OfMediansAndSlopesHaveIntervalsToo) {
  const BenchComparison comparison = compare(
      R"({"figures": [{"name": "od", "unit": "ns", "median": 4, "low": 2, "high": 8},
                      {"name": "slope", "median": -0.5, "low": -0.6, "high": -0.4}]})",
      R"({"figures": [{"name": "od", "unit": "ns", "median": 4, "low": 4, "high": 4},
                      {"name": "slope", "median": -0.6, "low": -0.6, "high": -0.6}]})");
  ASSERT_EQ(comparison.ratios.size(), 2U);
  EXPECT_EQ(comparison.ratios[0].figure, "figures[name=od,unit=ns]");
  EXPECT_NEAR(comparison.ratios[0].interval->low, 0.5, 1e-12);
  EXPECT_NEAR(comparison.ratios[0].interval->high, 2.0, 1e-12);
  EXPECT_NEAR(comparison.ratios[1].ratio, 1.2, 1e-12);
  EXPECT_NEAR(comparison.ratios[1].interval->low, 1.0, 1e-12);
  EXPECT_NEAR(comparison.ratios[1].interval->high, 1.5, 1e-12);
}

TEST(BenchRatios, HaveNoIntervalWhereOneFigureHasNone) {
  const BenchComparison comparison =
      compare(R"({"costs": [{"ratio": {"value": 2.0, "low": null, "high": null}}]})",
              R"({"costs": [{"ratio": {"value": 6.0, "low": 3.0, "high": 9.0}}]})");
  EXPECT_DOUBLE_EQ(comparison.ratios.at(0).ratio, 3.0);
  EXPECT_FALSE(comparison.ratios.at(0).interval);
}

TEST(BenchRatios, SayWhatDiffersAndWhatHasNoRatio) {
  const BenchComparison comparison = compare(R"({"width": 8, "plan": {"spp": 4}, "seed": 1,
                  "runs": [{"name": "x", "a": 1, "b": 0, "c": 2, "d": -1, "e": null}]})",
                                             R"({"width": 9, "plan": {"spp": 5}, "scene": "z",
                  "runs": [{"name": "x", "a": 1, "b": 3, "d": 1, "f": 7, "e": 1}]})");
  EXPECT_THAT(comparison.differing,
              ElementsAre("width: 8, now 9", R"(plan: {"spp":4}, now {"spp":5})",
                          "seed: 1, now absent", R"(scene: absent, now "z")"));
  EXPECT_THAT(comparison.unmatched,
              ElementsAre("runs[name=x].b", "runs[name=x].c", "runs[name=x].d", "runs[name=x].f",
                          "runs[name=x].e"));
  ASSERT_EQ(comparison.ratios.size(), 1U);
  EXPECT_EQ(comparison.ratios[0].figure, "runs[name=x].a");
}

TEST(BenchRatios, RefuseWhatCannotBeCompared) {
  EXPECT_THAT([] { (void)compare("nonsense", "{}"); },
              ThrowsMessage<Error>(HasSubstr("before.json: is no JSON object")));
  EXPECT_THAT([] { (void)compare(R"({"runs": [{"a": 1}]})", "[1, 2]"); },
              ThrowsMessage<Error>(HasSubstr("after.json: is no JSON object")));
  EXPECT_THAT([] { (void)compare(R"({"runs": [{"a": 1}]})", R"({"figures": [{"a": 1}]})"); },
              ThrowsMessage<Error>(HasSubstr("no figure in common")));
}

}  // namespace
}  // namespace foveola::analysis
