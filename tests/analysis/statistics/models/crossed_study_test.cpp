#include "analysis/statistics/models/crossed_study.h"

#include <cmath>

#include "analysis/statistics/distributions.h"
#include "analysis/statistics/models/crossed_model.h"
#include "analysis/statistics/power.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(CrossedStudy, HasTheVariancesOfItsDesign) {
  const CrossedDesign design{200, 200, -0.7, 0.2, 0.1, 0.3};
  Pcg32 generator(4);
  const CrossedModel model = crossed_model(draw_log_ratios(design, generator)).value();
  // Four standard errors: of a variance from 199 degrees of freedom that is 40 %.
  EXPECT_NEAR(model.mean, -0.7, 4.0 * std::hypot(0.2, 0.1) / std::sqrt(200.0));
  EXPECT_NEAR(model.participant_variance, 0.04, 0.4 * 0.04);
  EXPECT_NEAR(model.scene_variance, 0.01, 0.4 * 0.01);
  EXPECT_NEAR(model.residual_variance, 0.18, 4.0 * 0.18 * std::sqrt(2.0) / 199.0);
}

TEST(CrossedStudy, PartsOfASimulationAddUpToTheWhole) {
  const CrossedDesign design{.participants = 12, .participant_sd = 0.1, .scene_sd = 0.1};
  const CrossedCoverage whole = count_coverage(design, 0.0, 3, 0, 90);
  const CrossedCoverage part = count_coverage(design, 0.0, 3, 0, 40);
  const CrossedCoverage rest = count_coverage(design, 0.0, 3, 40, 90);
  EXPECT_EQ(whole.studies, 90U);
  EXPECT_EQ(whole.studies, part.studies + rest.studies);
  EXPECT_EQ(whole.crossed_model, part.crossed_model + rest.crossed_model);
  EXPECT_EQ(whole.over_participants, part.over_participants + rest.over_participants);
}

/// Whether a share is within `required` but for the chance of the simulation.
void expect_share(std::size_t hits, std::size_t studies, const Interval& required) {
  const Interval share = clopper_pearson(hits, studies, 0.999);
  EXPECT_GE(share.high, required.low) << hits;
  EXPECT_LE(share.low, required.high) << hits;
}

TEST(CrossedStudy, OnlyTheCrossedModelCoversWhereScenesDiffer) {
  const CrossedDesign design{.participants = 24, .participant_sd = 0.1, .scene_sd = 0.2};
  const CrossedCoverage counts = count_coverage(design, design.mean, 1, 0, 4000);
  expect_share(counts.crossed_model, counts.studies, {0.935, 0.965});
  EXPECT_LT(static_cast<double>(counts.over_participants), 0.7 * 4000.0);
}

TEST(CrossedStudy, BothCoverWhereScenesDoNotDiffer) {
  const CrossedDesign design{.participants = 16, .mean = -0.7, .participant_sd = 0.2};
  const CrossedCoverage counts = count_coverage(design, design.mean, 2, 0, 4000);
  // A variance that is 0 cannot be estimated below it: the interval is too wide rather than narrow.
  expect_share(counts.crossed_model, counts.studies, {0.95, 0.98});
  expect_share(counts.over_participants, counts.studies, {0.95, 0.95});
}

TEST(CrossedStudy, WhatDoesNotCoverNoEffectIsThePower) {
  // Without differences between scenes, a participant's mean of five has this standard deviation.
  const CrossedDesign design{.participants = 12, .mean = -0.25, .participant_sd = 0.2};
  const double sd = std::sqrt(0.04 + 2.0 * 0.09 / 5.0);
  constexpr std::size_t studies = 4000;
  const CrossedCoverage counts = count_coverage(design, 0.0, 7, 0, studies, 0.99);
  const double power = paired_t_power(12, {-0.25, sd}, 0.01);
  EXPECT_NEAR(static_cast<double>(studies - counts.over_participants) / studies, power,
              4.0 * std::sqrt(power * (1.0 - power) / studies));
  // What other scenes may be like costs some of it.
  EXPECT_GT(counts.crossed_model, counts.over_participants);
}

}  // namespace
}  // namespace foveola::analysis
