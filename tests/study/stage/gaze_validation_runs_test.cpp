#include "study/stage/gaze_validation_runs.h"

#include <gtest/gtest.h>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

/// A perfect eye on each target, seen by a tracker of 100 Hz that is off by so much to the right.
GazeValidated look_at_targets(const ValidationSettings& settings, double off_right_deg,
                              bool sees_anything = true) {
  constexpr double fov_deg = 60.0;
  GazeValidationRuns runs(settings, fov_deg, fov_deg, 0s);
  for (Nanoseconds now = 0s; now < 5min && !runs.result(); now += 10ms) {
    const AzimuthElevation angles = azimuth_elevation(*runs.target());
    const GazeSample seen{
        .time = now,
        .direction = direction_from({.azimuth_rad = angles.azimuth_rad + radians(off_right_deg),
                                     .elevation_rad = angles.elevation_rad}),
        .valid = sees_anything};
    runs.update(now, std::vector{seen});
  }
  EXPECT_TRUE(runs.result());
  EXPECT_FALSE(runs.target());
  return runs.result().value_or(GazeValidated{});
}

TEST(GazeValidationRuns, PassesAGoodTracker) {
  const GazeValidated validated = look_at_targets({.points = 5}, 0.5);
  EXPECT_TRUE(validated.passed);
  ASSERT_EQ(validated.runs.size(), 1U);
  EXPECT_EQ(validated.runs[0].quality.targets.size(), 5U);
  // Half a degree of azimuth is less of angle at targets that lie up or down.
  EXPECT_NEAR(validated.runs[0].quality.figures->accuracy_deg, 0.5, 0.05);
  EXPECT_FALSE(validated.runs[0].correction);
}

TEST(GazeValidationRuns, RefusesABadOne) {
  const GazeValidated validated = look_at_targets({.points = 9}, 3.0);
  EXPECT_FALSE(validated.passed);
  EXPECT_EQ(validated.runs[0].quality.targets.size(), 9U);
}

TEST(GazeValidationRuns, CorrectsABadOneIfTheProtocolSaysSo) {
  const GazeValidated validated = look_at_targets({.points = 5, .correct = true}, 3.0);
  EXPECT_TRUE(validated.passed);
  ASSERT_EQ(validated.runs.size(), 2U);
  EXPECT_FALSE(validated.runs[0].passed);
  ASSERT_TRUE(validated.runs[1].correction);
  EXPECT_NEAR(validated.runs[1].correction->azimuth.x, -3.0, 0.05);
  EXPECT_LT(validated.runs[1].quality.figures->accuracy_deg, 0.05);
}

TEST(GazeValidationRuns, WhatWasNotSeenCannotBeCorrected) {
  const GazeValidated validated = look_at_targets({.points = 5, .correct = true}, 0.0, false);
  EXPECT_FALSE(validated.passed);
  ASSERT_EQ(validated.runs.size(), 1U);
  EXPECT_DOUBLE_EQ(validated.runs[0].quality.data_loss, 1.0);
}

}  // namespace
}  // namespace foveola::study
