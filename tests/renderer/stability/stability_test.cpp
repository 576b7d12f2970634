#include "renderer/stability/stability.h"

#include <gtest/gtest.h>

#include "renderer/stability/checks.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

/// So little that only the order of events matters.
constexpr StabilityEffort least{.tolerance = 1.0,
                                .most_samples = 1,
                                .picture_samples_per_pixel = 1,
                                .leak_paths = 1,
                                .scene_paths = 1,
                                .film_samples = 1};

TEST(StabilityTest, StoppedBeforeTheFirstTestEndsThereAreNoFigures) {
  std::stop_source stop;
  std::vector<std::string> tests;
  const auto progress = [&](double, const std::string& test) {
    tests.push_back(test);
    stop.request_stop();
  };
  const Workers workers(1);
  EXPECT_TRUE(measure_stability(least, {}, workers, progress, stop.get_token()).empty());
  EXPECT_EQ(tests.back(), tests.front());
}

TEST(StabilityTest, ProgressRunsFromZeroToOne) {
  double last = 0.0;
  const auto progress = [&](double fraction, const std::string&) {
    EXPECT_GE(fraction, last - 1e-9);
    EXPECT_LE(fraction, 1.0 + 1e-9);
    last = fraction;
  };
  const Workers workers(2);
  const auto figures = measure_stability(least, {}, workers, progress, {});
  EXPECT_GT(figures.size(), 20U);
  EXPECT_GT(last, 0.8);  // without scenes there is no last test
}

TEST(StabilityTest, NotANumberDoesNotPass) {
  EXPECT_TRUE((StabilityFigure{.measured = 1.0, .bound = 1.0}).passes());
  EXPECT_FALSE((StabilityFigure{.measured = 1.1, .bound = 1.0}).passes());
  EXPECT_FALSE((StabilityFigure{.measured = std::nan(""), .bound = 1.0}).passes());
}

}  // namespace
}  // namespace foveola
