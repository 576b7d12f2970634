#include <gtest/gtest.h>

#include "analysis/monte_carlo/censored_coverage.h"

namespace foveola::analysis {
namespace {

std::vector<CoverageFigure> measure(int threads) {
  return measure_crossed_coverage({.studies = 300, .threads = threads}, [](double) {}, {});
}

TEST(CrossedCoverage, IsNearlyNominalWherePeopleAndScenesDiffer) {
  const std::vector<CoverageFigure> figures = measure(0);
  ASSERT_EQ(figures.size(), 4U * 3U * 3U * 2U);
  for (std::size_t i = 0; i < figures.size(); i += 2) {
    EXPECT_GT(figures[i].percent, 90.0) << figures[i].name;
    EXPECT_TRUE(figures[i].required) << figures[i].name;
    EXPECT_FALSE(figures[i + 1].required) << figures[i + 1].name;
  }
  // 40 people, no difference between them, scenes at 0.2: t covers half.
  EXPECT_LT(figures[2 * 29 + 1].percent, 60.0) << figures[2 * 29 + 1].name;
}

TEST(CrossedCoverage, DoesNotDependOnThreads) {
  const std::vector<CoverageFigure> one = measure(1);
  const std::vector<CoverageFigure> four = measure(4);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].hits, four[i].hits) << one[i].name;
  }
}

TEST(CrossedCoverage, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(measure_crossed_coverage({}, [](double) {}, stop.get_token()).empty());
}

}  // namespace
}  // namespace foveola::analysis
