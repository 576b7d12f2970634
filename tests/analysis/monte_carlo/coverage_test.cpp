#include "analysis/monte_carlo/coverage.h"

#include <gtest/gtest.h>

namespace foveola::analysis {
namespace {

std::vector<CoverageFigure> measure(const CoverageSettings& settings) {
  return measure_injected_coverage(settings, [](double) {}, {});
}

TEST(Coverage, DoesNotDependOnThreads) {
  CoverageSettings settings{.studies = 60, .participants = 8, .resamples = 99, .threads = 1};
  const std::vector<CoverageFigure> alone = measure(settings);
  settings.threads = 4;
  const std::vector<CoverageFigure> together = measure(settings);
  ASSERT_EQ(alone.size(), together.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(alone[i].hits, together[i].hits) << alone[i].name;
    EXPECT_EQ(alone[i].studies, 60U) << alone[i].name;
  }
}

TEST(Coverage, IntervalsCoverAndTestsSeldomReject) {
  for (const CoverageFigure& figure : measure({.studies = 200, .resamples = 199})) {
    const bool is_coverage = figure.claim.starts_with("covers");
    EXPECT_GT(figure.percent, is_coverage ? 80.0 : -1.0) << figure.name;
    EXPECT_LT(figure.percent, is_coverage ? 100.1 : 15.0) << figure.name;
    EXPECT_LE(figure.interval.low, figure.percent);
    EXPECT_GE(figure.interval.high, figure.percent);
  }
}

TEST(Coverage, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(measure_injected_coverage({}, [](double) {}, stop.get_token()).empty());
}

}  // namespace
}  // namespace foveola::analysis
