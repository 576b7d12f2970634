#include "renderer/gaze/gaze_correction.h"

#include <chrono>
#include <cmath>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/gaze/calibration_routine.h"
#include "renderer/gaze/recorded_eye_tracker.h"
#include "tests/renderer/gaze/gaze_expectations.h"

namespace foveola {
namespace {

using test::at_deg;

double between_deg(const Vec3& a, const Vec3& b) { return degrees(angle_between(a, b)); }

TargetQuality target(const Vec3& direction, const Vec3& mean_gaze) {
  return {.direction = direction, .data_loss = 0.0, .seen = SeenTarget{.mean_gaze = mean_gaze}};
}

/// A tracker that turns, stretches, shears and shifts what it sees.
Vec3 distorted(const Vec3& direction) {
  const AzimuthElevation angles = azimuth_elevation(direction);
  const double azimuth_deg = degrees(angles.azimuth_rad);
  const double elevation_deg = degrees(angles.elevation_rad);
  return at_deg(1.5 + 0.9 * azimuth_deg - 0.1 * elevation_deg,
                -2.0 + 0.05 * azimuth_deg + 1.2 * elevation_deg);
}

TEST(GazeCorrection, OfNothingChangesNothing) {
  EXPECT_LT(between_deg(corrected(at_deg(20.0, -10.0), {}), at_deg(20.0, -10.0)), 1e-4);
}

TEST(GazeCorrection, CombinedIsOneAfterTheOther) {
  const GazeCorrection first{.azimuth = {1.0, 0.9, -0.1}, .elevation = {-2.0, 0.2, 1.1}};
  const GazeCorrection second{.azimuth = {-3.0, 1.2, 0.3}, .elevation = {0.5, -0.1, 0.8}};
  for (const Vec3& direction : {at_deg(0.0, 0.0), at_deg(12.0, -7.0), at_deg(-20.0, 15.0)}) {
    EXPECT_LT(between_deg(corrected(direction, combined(first, second)),
                          corrected(corrected(direction, first), second)),
              1e-4);
  }
}

TEST(GazeCorrection, UndoesAnAffineDistortion) {
  for (const int points : {5, 9}) {
    std::vector<TargetQuality> targets;
    for (const Vec3& direction : calibration_targets(points, 60.0, 40.0)) {
      targets.push_back(target(direction, distorted(direction)));
    }
    const auto correction = fit_correction(targets);
    ASSERT_TRUE(correction);
    for (const Vec3& elsewhere : {at_deg(7.0, -3.0), at_deg(-25.0, 12.0), at_deg(0.0, 15.0)}) {
      EXPECT_LT(between_deg(corrected(distorted(elsewhere), *correction), elsewhere), 1e-3);
    }
  }
}

// Of measured values 0, 1 and 2 that should be 0, 0 and 3 the least squares' line is -0.5 + 1.5 x.
// Repeated in two rows, which add nothing, so that the elevation is determined as well.
TEST(GazeCorrection, IsTheLeastSquaresFit) {
  std::vector<TargetQuality> targets;
  for (const double elevation_deg : {-5.0, 5.0}) {
    targets.push_back(target(at_deg(0.0, elevation_deg), at_deg(0.0, elevation_deg)));
    targets.push_back(target(at_deg(0.0, elevation_deg), at_deg(10.0, elevation_deg)));
    targets.push_back(target(at_deg(30.0, elevation_deg), at_deg(20.0, elevation_deg)));
  }
  const auto correction = fit_correction(targets);
  ASSERT_TRUE(correction);
  EXPECT_NEAR(correction->azimuth.x, -5.0, 1e-3);
  EXPECT_NEAR(correction->azimuth.y, 1.5, 1e-4);
  EXPECT_NEAR(correction->azimuth.z, 0.0, 1e-4);
  EXPECT_NEAR(correction->elevation.x, 0.0, 1e-3);
  EXPECT_NEAR(correction->elevation.y, 0.0, 1e-4);
  EXPECT_NEAR(correction->elevation.z, 1.0, 1e-4);
}

TEST(GazeCorrection, IsNotFittedToGazesThatDoNotDetermineIt) {
  std::vector<TargetQuality> none;
  std::vector<TargetQuality> unseen;
  std::vector<TargetQuality> frozen;
  std::vector<TargetQuality> on_a_line;
  for (const Vec3& direction : calibration_targets(9, 60.0, 40.0)) {
    unseen.push_back({.direction = direction});
    frozen.push_back(target(direction, at_deg(3.0, 2.0)));
    const double azimuth_deg = degrees(azimuth_elevation(direction).azimuth_rad);
    on_a_line.push_back(target(direction, at_deg(azimuth_deg, 0.5 * azimuth_deg)));
  }
  EXPECT_FALSE(fit_correction(none));
  EXPECT_FALSE(fit_correction(unseen));
  EXPECT_FALSE(fit_correction(frozen));
  EXPECT_FALSE(fit_correction(on_a_line));
  std::vector<TargetQuality> two = {target(at_deg(-9.0, 9.0), at_deg(-9.0, 9.0)),
                                    target(at_deg(9.0, -9.0), at_deg(9.0, -9.0))};
  EXPECT_FALSE(fit_correction(two));
  two.push_back(target(at_deg(9.0, 9.0), at_deg(9.0, 9.0)));
  EXPECT_TRUE(fit_correction(two)) << "three that make a triangle do";
}

TEST(CorrectedEyeTracker, CorrectsValidSamplesAndNothingElse) {
  const std::vector<GazeSample> samples = {
      {.time = Nanoseconds(1), .direction = at_deg(10.0, 5.0), .valid = true},
      {.time = Nanoseconds(2)}};
  CorrectedEyeTracker tracker(
      std::make_unique<RecordedEyeTracker>(samples, Nanoseconds(0), Nanoseconds(0)),
      {.azimuth = {1.0, 0.5, 0.0}, .elevation = {0.0, 0.2, 1.0}});
  std::vector<GazeSample> arrived = {{.direction = at_deg(40.0, 0.0), .valid = true}};
  tracker.poll(Nanoseconds(2), arrived);
  ASSERT_EQ(arrived.size(), 3U);
  EXPECT_EQ(arrived[0].direction, at_deg(40.0, 0.0)) << "is of before";
  EXPECT_LT(between_deg(arrived[1].direction, at_deg(6.0, 7.0)), 1e-4);
  EXPECT_EQ(arrived[1].time, Nanoseconds(1));
  EXPECT_FALSE(arrived[2].valid);
  EXPECT_EQ(arrived[2].direction, samples[1].direction);
}

TEST(CorrectedEyeTracker, CorrectsWhatItHasCorrectedOnceMore) {
  const std::vector<GazeSample> samples = {
      {.time = Nanoseconds(1), .direction = at_deg(10.0, 5.0), .valid = true},
      {.time = Nanoseconds(2), .direction = at_deg(10.0, 5.0), .valid = true},
      {.time = Nanoseconds(3), .direction = at_deg(10.0, 5.0), .valid = true}};
  CorrectedEyeTracker tracker(
      std::make_unique<RecordedEyeTracker>(samples, Nanoseconds(0), Nanoseconds(0)));
  std::vector<GazeSample> arrived;
  tracker.poll(Nanoseconds(1), arrived);
  tracker.add({.azimuth = {-4.0, 1.0, 0.0}});
  tracker.poll(Nanoseconds(2), arrived);
  tracker.add({.azimuth = {0.0, 0.5, 0.0}});
  tracker.poll(Nanoseconds(3), arrived);
  ASSERT_EQ(arrived.size(), 3U);
  EXPECT_EQ(arrived[0].direction, samples[0].direction) << "to the bit";
  EXPECT_LT(between_deg(arrived[1].direction, at_deg(6.0, 5.0)), 1e-4);
  EXPECT_LT(between_deg(arrived[2].direction, at_deg(3.0, 5.0)), 1e-4);
}

constexpr double off_right_deg = 1.2;
constexpr double off_up_deg = -0.8;

class GazeCheckTest : public testing::Test {
 protected:
  /// Someone who looks at each target as long as it is there.
  std::vector<WatchedTarget> look_at_targets() {
    CalibrationRoutine routine(calibration_targets(5, 60.0, 40.0), {}, now_);
    while (const std::optional<Vec3> target = routine.target()) {
      gaze_ = *target;
      now_ += std::chrono::milliseconds(10);
      std::vector<GazeSample> arrived;
      tracker_.poll(now_, arrived);
      routine.update(now_, arrived);
    }
    return routine.watched();
  }

  Nanoseconds now_{0};
  Vec3 gaze_{0.0F, 0.0F, -1.0F};
  /// Sees every gaze beside where it is, 100 times a second.
  CorrectedEyeTracker tracker_{std::make_unique<SimulatedEyeTracker>(
      SimulatedTrackerSettings{.rate_hz = 100.0,
                               .latency_s = 0.0,
                               .precision_deg = 0.0,
                               .bias_right_deg = off_right_deg,
                               .bias_up_deg = off_up_deg},
      [this](Nanoseconds) { return gaze_; })};
};

TEST_F(GazeCheckTest, CorrectsIfAsked) {
  const GazeCheck before = check_gaze(look_at_targets(), true, tracker_);
  ASSERT_TRUE(before.quality.figures);
  EXPECT_NEAR(before.quality.figures->accuracy_deg, std::hypot(off_right_deg, off_up_deg), 0.03);
  ASSERT_TRUE(before.correction);
  EXPECT_NEAR(before.correction->azimuth.x, -off_right_deg, 0.01);
  EXPECT_NEAR(before.correction->elevation.x, -off_up_deg, 0.01);
  const GazeCheck after = check_gaze(look_at_targets(), true, tracker_);
  ASSERT_TRUE(after.quality.figures);
  EXPECT_LT(after.quality.figures->accuracy_deg, 1e-3);
}

TEST_F(GazeCheckTest, OnlyJudgesOtherwise) {
  EXPECT_FALSE(check_gaze(look_at_targets(), false, tracker_).correction);
  const GazeCheck again = check_gaze(look_at_targets(), false, tracker_);
  EXPECT_NEAR(again.quality.figures->accuracy_deg, std::hypot(off_right_deg, off_up_deg), 0.03);
}

TEST_F(GazeCheckTest, DoesNotCorrectByAGazeThatRests) {
  std::vector<WatchedTarget> watched = look_at_targets();
  for (WatchedTarget& target : watched) {
    for (GazeSample& sample : target.samples) {
      sample.direction = Vec3(0.0F, 0.0F, -1.0F);
    }
  }
  EXPECT_FALSE(check_gaze(watched, true, tracker_).correction);
}

}  // namespace
}  // namespace foveola
