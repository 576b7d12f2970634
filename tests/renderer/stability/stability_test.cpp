#include "renderer/stability/stability.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace foveola {
namespace {

/// Reports half of its work, and then one figure of its own name.
StabilityCheck check_named(const std::string& name, double weight) {
  return {.name = name, .weight = weight, .run = [name](const StabilityRun& run) {
            run.progress(0.5);
            return std::vector<StabilityFigure>{{.name = name}};
          }};
}

TEST(StabilityTest, ProgressFollowsTheWeightsOfTheChecks) {
  std::vector<std::pair<double, std::string>> seen;
  const auto progress = [&](double fraction, const std::string& check) {
    seen.emplace_back(fraction, check);
  };
  const Workers workers(1);
  const auto figures = measure_stability({check_named("short", 1.0), check_named("long", 3.0)}, {},
                                         workers, progress, {});
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].name, "short");
  EXPECT_EQ(figures[1].name, "long");
  const std::vector<std::pair<double, std::string>> expected{
      {0.0, "short"}, {0.125, "short"}, {0.25, "long"}, {0.625, "long"}};
  EXPECT_EQ(seen, expected);
}

TEST(StabilityTest, TheCheckThatIsStoppedHasNoFigures) {
  std::stop_source stop;
  const auto progress = [&](double fraction, const std::string&) {
    if (fraction > 0.4) {
      stop.request_stop();
    }
  };
  const Workers workers(1);
  const auto figures = measure_stability(
      {check_named("first", 1.0), check_named("second", 1.0), check_named("third", 1.0)}, {},
      workers, progress, stop.get_token());
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "first");
}

TEST(StabilityTest, EveryCheckIsInTheList) {
  const auto checks = stability_checks({});
  EXPECT_EQ(checks.size(), 9U);
  for (const StabilityCheck& check : checks) {
    EXPECT_TRUE(check.run);
    EXPECT_GT(check.weight, 0.0);
  }
}

TEST(StabilityTest, NotANumberDoesNotPass) {
  EXPECT_TRUE((StabilityFigure{.measured = 1.0, .bound = 1.0}).passes());
  EXPECT_FALSE((StabilityFigure{.measured = 1.1, .bound = 1.0}).passes());
  EXPECT_FALSE((StabilityFigure{.measured = std::nan(""), .bound = 1.0}).passes());
}

}  // namespace
}  // namespace foveola
