#include "analysis/replication/bench_ratios.h"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

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
  EXPECT_DOUBLE_EQ(comparison.ratios[0].ratio.value(), 0.75);
  EXPECT_FALSE(comparison.ratios[0].interval);
  EXPECT_EQ(comparison.ratios[1].figure, "runs[threads=1].rays.shadow");
  EXPECT_DOUBLE_EQ(comparison.ratios[1].ratio.value(), 2.0);
  EXPECT_EQ(comparison.ratios[2].figure, "runs[threads=2].seconds");
  EXPECT_DOUBLE_EQ(comparison.ratios[2].ratio.value(), 0.5);
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
  EXPECT_DOUBLE_EQ(row.ratio.value(), 3.0);
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
  EXPECT_NEAR(comparison.ratios[1].ratio.value(), 1.2, 1e-12);
  EXPECT_NEAR(comparison.ratios[1].interval->low, 1.0, 1e-12);
  EXPECT_NEAR(comparison.ratios[1].interval->high, 1.5, 1e-12);
}

TEST(BenchRatios, HaveNoIntervalWhereOneFigureHasNone) {
  const BenchComparison comparison =
      compare(R"({"costs": [{"ratio": {"value": 2.0, "low": null, "high": null}}]})",
              R"({"costs": [{"ratio": {"value": 6.0, "low": 3.0, "high": 9.0}}]})");
  EXPECT_DOUBLE_EQ(comparison.ratios.at(0).ratio.value(), 3.0);
  EXPECT_FALSE(comparison.ratios.at(0).interval);
}

TEST(BenchRatios, SayWhatDiffersAndWhatHasNoRatio) {
  const BenchComparison comparison = compare(
      R"({"width": 8, "plan": {"spp": 4}, "seed": 1, "processor": "A", "date": "2026-01-01",
                  "runs": [{"name": "x", "a": 1, "b": 0, "c": 2, "d": -1, "e": null}]})",
      R"({"width": 9, "plan": {"spp": 5}, "scene": "z", "processor": "B", "date": "2026-01-02",
                  "runs": [{"name": "x", "a": 1, "b": 3, "d": 1, "f": 7, "e": 1}]})");
  EXPECT_THAT(comparison.differing,
              ElementsAre("width: 8, now 9", "plan.spp: 4, now 5", "seed: 1, now absent",
                          R"(processor: "A", now "B")", R"(scene: absent, now "z")"));
  EXPECT_THAT(comparison.unmatched,
              ElementsAre("runs[name=x].c", "runs[name=x].f", "runs[name=x].e"));
  ASSERT_EQ(comparison.ratios.size(), 3U);
  EXPECT_EQ(comparison.ratios[0].figure, "runs[name=x].a");
  EXPECT_EQ(comparison.ratios[0].move, BenchMove::none);
  EXPECT_EQ(comparison.ratios[1].figure, "runs[name=x].b");
  EXPECT_FALSE(comparison.ratios[1].ratio);
  EXPECT_EQ(comparison.ratios[1].move, BenchMove::exactly);
  EXPECT_FALSE(comparison.ratios[2].ratio) << "from -1 to 1";
}

/// Runs of so many figures of 100, each 95 % sure within a tenth of a per cent, but for the first.
std::string runs(int count, double first) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double value = i == 0 ? first : 100.0;
    text += fmt::format(R"({}{{"name": "{}", "median": {}, "low": {}, "high": {}}})",
                        i == 0 ? "" : ", ", i, value, value * 0.999, value / 0.999);
  }
  return R"({"figures": [)" + text + "]}";
}

TEST(BenchMoves, EqualRunsHaveNone) {
  const BenchComparison comparison = compare(runs(20, 100.0), runs(20, 100.0));
  EXPECT_EQ(comparison.moved(BenchMove::none).size(), 20U);
  EXPECT_EQ(comparison.count(BenchFigureKind::with_interval), 20U);
}

// The ratio's 95 % interval is sqrt(2) tenths of a per cent to each side. Of 20 figures together,
// each has 0.95^(1/20) = 99.744 %, whose normal quantile is 3.0163, so it is 1.539 times as wide:
// 2.176 tenths (by R's qnorm).
TEST(BenchMoves, OfManyFiguresOneMustMoveFurther) {
  const auto move = [](double first) {
    return compare(runs(20, 100.0), runs(20, first)).ratios.at(0).move;
  };
  EXPECT_EQ(move(100.14), BenchMove::none);
  EXPECT_EQ(move(100.15), BenchMove::alone);
  EXPECT_EQ(move(100.21), BenchMove::alone);
  EXPECT_EQ(move(100.22), BenchMove::together);
  EXPECT_EQ(move(99.78), BenchMove::together);
  EXPECT_EQ(compare(runs(1, 100.0), runs(1, 100.15)).ratios.at(0).move, BenchMove::together)
      << "one figure has nothing to be judged together with";
  EXPECT_NEAR(compare(runs(20, 100.0), runs(20, 100.0)).level_of_each, 0.997439, 1e-6);
}

TEST(BenchMoves, ExactFiguresMoveByTheLastBit) {
  const std::string before = R"({"figures": [{"what": "error", "value": 0.1}]})";
  EXPECT_EQ(compare(before, before).ratios.at(0).move, BenchMove::none);
  const BenchComparison moved =
      compare(before, R"({"figures": [{"what": "error", "value": 0.10000000000000002}]})");
  EXPECT_EQ(moved.ratios.at(0).figure, "figures[what=error].value");
  EXPECT_EQ(moved.ratios.at(0).move, BenchMove::exactly);
}

TEST(BenchMoves, FiguresAroundZeroAreJudgedByTheirDifference) {
  const auto move = [](const char* after) {
    return compare(R"({"figures": [{"name": "a", "value": 0.0, "low": -1.0, "high": 1.0}]})", after)
        .ratios.at(0)
        .move;
  };
  EXPECT_EQ(move(R"({"figures": [{"name": "a", "value": 1.4, "low": 0.4, "high": 2.4}]})"),
            BenchMove::none);
  EXPECT_EQ(move(R"({"figures": [{"name": "a", "value": 1.5, "low": 0.5, "high": 2.5}]})"),
            BenchMove::together);
}

TEST(BenchMoves, WithoutAnIntervalNobodyKnows) {
  const BenchComparison comparison =
      compare(R"({"seconds": {"value": 80.0, "low": null, "high": null}})",
              R"({"seconds": {"value": 81.0, "low": null, "high": null}})");
  EXPECT_EQ(comparison.ratios.at(0).figure, "seconds");
  EXPECT_EQ(comparison.ratios.at(0).move, BenchMove::without_interval);
}

TEST(BenchRatios, RefuseWhatCannotBeCompared) {
  EXPECT_THAT([] { (void)compare("nonsense", "{}"); },
              ThrowsMessage<Error>(HasSubstr("before.json: is not a JSON object")));
  EXPECT_THAT([] { (void)compare(R"({"runs": [{"a": 1}]})", "[1, 2]"); },
              ThrowsMessage<Error>(HasSubstr("after.json: is not a JSON object")));
  EXPECT_THAT([] { (void)compare(R"({"runs": [{"a": 1}]})", R"({"figures": [{"a": 1}]})"); },
              ThrowsMessage<Error>(HasSubstr("no figure in common")));
}

}  // namespace
}  // namespace foveola::analysis
