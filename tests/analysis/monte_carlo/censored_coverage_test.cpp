#include "analysis/monte_carlo/censored_coverage.h"

#include <gtest/gtest.h>

namespace foveola::analysis {
namespace {

std::vector<CoverageFigure> measure_censored(int threads) {
  return measure_censored_coverage({.studies = 60, .threads = threads}, [](double) {}, {});
}

// Where slow times are left out, what is left of the baseline's are those that were fast.
TEST(CensoredCoverage, RatiosOfWhatIsNotCensoredAreTooNearToOne) {
  const std::vector<CoverageFigure> figures = measure_censored(0);
  ASSERT_EQ(figures.size(), 4U * 3U * 3U * 2U * 2U);
  for (const CoverageFigure& figure : figures) {
    EXPECT_FALSE(figure.required) << figure.name;
    EXPECT_GT(*figure.mean_ratio, 0.5) << figure.name;
  }
  // Of 40 people whom scenes and people do not tell apart, with a third of the times censored.
  const CoverageFigure& fixed = figures[27 * 4 + 3];
  EXPECT_EQ(fixed.name, "without R, scenes fixed, 32 % censored, 40 × 5, SD 0 people, 0 scenes");
  EXPECT_LT(fixed.percent, 80.0);
}

TEST(CensoredCoverage, DoesNotDependOnThreads) {
  const std::vector<CoverageFigure> one = measure_censored(1);
  const std::vector<CoverageFigure> four = measure_censored(4);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].hits, four[i].hits) << one[i].name;
    EXPECT_EQ(one[i].mean_ratio, four[i].mean_ratio) << one[i].name;
  }
}

TEST(CensoredCoverage, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(measure_censored_coverage({}, [](double) {}, stop.get_token()).empty());
}

}  // namespace
}  // namespace foveola::analysis
