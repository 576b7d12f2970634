#include <cmath>

#include <gtest/gtest.h>

#include "analysis/dataset/comparisons.h"
#include "analysis/monte_carlo/censored_coverage.h"

namespace foveola::analysis {
namespace {

/// The share of the baseline's times that is right-censored, over some studies.
double censored_share(double wanted) {
  const ExpectedStudy expected =
      gain_study({.participants_gain = 0.2, .scenes_gain = 0.2, .censored = wanted});
  std::size_t censored = 0;
  std::size_t all = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Dataset set = select_for_analysis(draw_study(expected, 8, seed));
    for (std::size_t participant = 0; participant < 8; ++participant) {
      for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
        ++all;
        censored +=
            set.value(participant, scene, baseline, 0).state == study::Value::State::right_censored
                ? 1
                : 0;
      }
    }
  }
  return static_cast<double>(censored) / static_cast<double>(all);
}

TEST(GainStudy, CensorsTheWantedShareOfTheBaselinesTimes) {
  EXPECT_EQ(censored_share(0.0), 0.0);
  EXPECT_NEAR(censored_share(0.13), 0.13, 0.02);
  EXPECT_NEAR(censored_share(0.5), 0.5, 0.03);
}

// Over participants, t is of the ratio in these scenes, and not of that in all.
TEST(GainStudy, KnowsTheRatioInTheScenesThatAreDrawn) {
  const ExpectedStudy expected = gain_study(
      {.participants_gain = 0.1, .scenes_gain = 0.2, .scenes = study::SceneEffects::fixed});
  constexpr std::size_t studies = 1000;
  std::size_t in_these = 0;
  std::size_t in_all = 0;
  for (std::uint64_t seed = 0; seed < studies; ++seed) {
    const Dataset set = select_for_analysis(draw_study(expected, 16, seed));
    const auto found = planned_primary_analyses(set, expected.protocol.analysis).front().primary;
    const auto covers = [&](double truth) {
      return found->interval->low <= truth && truth <= found->interval->high ? 1 : 0;
    };
    in_these += covers(log_ratio_in_drawn_scenes(expected, seed));
    in_all += covers(std::log(0.5));
  }
  EXPECT_NEAR(static_cast<double>(in_these) / studies, 0.95, 0.02);
  EXPECT_LT(static_cast<double>(in_all) / studies, 0.8);
}

}  // namespace
}  // namespace foveola::analysis
