#include "renderer/gaze/calibration.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/gaze/recordings.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/gaze_expectations.h"
#include "tests/renderer/gaze/test_eye_tracker.h"

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

using std::chrono::milliseconds;
using std::chrono::seconds;

double angle_deg(const Vec3& a, const Vec3& b) { return degrees(angle_between(a, b)); }

TEST(CalibrationTargets, AreTheMiddleAndTheCornersOrAGrid) {
  const std::vector<Vec3> five = calibration_targets(5, 90.0, 90.0);
  const std::vector<Vec3> nine = calibration_targets(9, 90.0, 90.0);
  ASSERT_EQ(five.size(), 5U);
  ASSERT_EQ(nine.size(), 9U);
  EXPECT_EQ(five[0], Vec3(0.0F, 0.0F, -1.0F));
  EXPECT_EQ(nine[0], five[0]);
  for (std::size_t i = 1; i < five.size(); ++i) {
    EXPECT_NE(five[i].x, 0.0F);
    EXPECT_NE(five[i].y, 0.0F);
    EXPECT_THAT(nine, Contains(five[i]));
  }
  for (std::size_t i = 0; i < nine.size(); ++i) {
    EXPECT_NEAR(glm::length(nine[i]), 1.0F, 1e-6F);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(angle_deg(nine[i], nine[j]), 10.0);
    }
  }
}

TEST(CalibrationTargets, StayInTheViewAndWhereTheEyeGoesAlone) {
  const auto farthest = [](double horizontal_fov_deg, double vertical_fov_deg) {
    DVec2 reach(0.0);
    for (const Vec3& target : calibration_targets(9, horizontal_fov_deg, vertical_fov_deg)) {
      reach = glm::max(reach, glm::abs(DVec2(target.x, target.y) / static_cast<double>(target.z)));
    }
    return reach;
  };
  EXPECT_NEAR(farthest(100.0, 100.0).x, std::tan(radians(20.0)), 1e-6);
  EXPECT_NEAR(farthest(100.0, 100.0).y, std::tan(radians(20.0)), 1e-6);
  EXPECT_NEAR(farthest(30.0, 20.0).x, 0.8 * std::tan(radians(15.0)), 1e-6);
  EXPECT_NEAR(farthest(30.0, 20.0).y, 0.8 * std::tan(radians(10.0)), 1e-6);
}

/// An eye that jumps to where it is sent, 0.3 s later.
class ObedientEye {
 public:
  void look_at(const Vec3& target, Nanoseconds now) {
    before_ = target_;
    target_ = target;
    arrival_ = now + milliseconds(300);
  }
  std::optional<Vec3> gaze(Nanoseconds time) const {
    const bool blinks = time >= blink_start && time < blink_end;
    return blinks ? std::nullopt : std::optional(time < arrival_ ? before_ : target_);
  }

  Nanoseconds blink_start{0};
  Nanoseconds blink_end{0};

 private:
  Vec3 before_{0.0F, 0.0F, -1.0F};
  Vec3 target_{0.0F, 0.0F, -1.0F};
  Nanoseconds arrival_{0};
};

struct Outcome {
  std::vector<WatchedTarget> watched;
  Nanoseconds duration{0};
};

/// At 100 frames a second.
Outcome run(const std::vector<Vec3>& targets, ObedientEye& eye, EyeTracker& tracker,
            const CalibrationTiming& timing = {}) {
  VirtualClock clock;
  clock.advance(seconds(100));
  CalibrationRoutine routine(targets, timing, clock.now());
  const Nanoseconds start = clock.now();
  std::optional<Vec3> shown;
  std::vector<GazeSample> arrived;
  while (const std::optional<Vec3> target = routine.target()) {
    if (target != shown) {
      eye.look_at(*target, clock.now());
      shown = target;
    }
    clock.advance(milliseconds(10));
    arrived.clear();
    tracker.poll(clock.now(), arrived);
    routine.update(clock.now(), arrived);
  }
  return {.watched = routine.watched(), .duration = clock.now() - start};
}

Outcome run(const std::vector<Vec3>& targets, ObedientEye& eye,
            const SimulatedTrackerSettings& settings, const CalibrationTiming& timing = {}) {
  SimulatedEyeTracker tracker(settings, [&](Nanoseconds time) { return eye.gaze(time); });
  return run(targets, eye, tracker, timing);
}

TEST(CalibrationRoutine, WatchesEachTargetOnceTheEyeHasSettled) {
  const std::vector<Vec3> targets = calibration_targets(9, 60.0, 60.0);
  ObedientEye eye;
  const Outcome outcome =
      run(targets, eye, {.rate_hz = 200.0, .latency_s = 0.1, .precision_deg = 0.0});
  ASSERT_EQ(outcome.watched.size(), 9U);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const WatchedTarget& watched = outcome.watched[i];
    EXPECT_EQ(watched.direction, targets[i]);
    EXPECT_EQ(watched.end - watched.start, seconds(1)) << "at 200 Hz samples come every 5 ms";
    ASSERT_EQ(watched.samples.size(), 201U);
    for (const GazeSample& sample : watched.samples) {
      ASSERT_LT(angle_deg(sample.direction, targets[i]), 1e-3);
    }
  }
  // To settle, to collect, and the latency.
  EXPECT_EQ(outcome.duration, 9 * milliseconds(700 + 1000 + 100));
}

TEST(CalibrationRoutine, ABlinkTakesLonger) {
  ObedientEye eye;
  eye.blink_start = seconds(101);
  eye.blink_end = eye.blink_start + milliseconds(200);
  const Outcome outcome = run({Vec3(0.0F, 0.0F, -1.0F)}, eye, {.rate_hz = 200.0, .latency_s = 0.0});
  EXPECT_EQ(outcome.duration, milliseconds(1700 + 200 + 10)) << "with the frame it ends in";
  EXPECT_NEAR(gaze_quality(outcome.watched).data_loss, 0.2 / 1.2, 0.01);
}

TEST(CalibrationRoutine, SamplesThatComeRarelyCountOnlyIfTheTimingSaysSo) {
  const std::vector<Vec3> targets = calibration_targets(5, 60.0, 60.0);
  const SimulatedTrackerSettings ten_a_second{.rate_hz = 10.0, .latency_s = 0.0};
  ObedientEye eye;
  EXPECT_EQ(run(targets, eye, ten_a_second).duration, 5 * seconds(4)) << "given up";
  const CalibrationTiming patient{.longest_interval = milliseconds(100)};
  EXPECT_EQ(run(targets, eye, ten_a_second, patient).duration, 5 * milliseconds(700 + 1000));
}

TEST(CalibrationRoutine, GivesUpATargetThatIsNotSeen) {
  const std::vector<Vec3> targets = calibration_targets(5, 60.0, 60.0);
  ObedientEye eye;
  const Outcome outcome = run(targets, eye, {.latency_s = 0.0, .data_loss = 1.0});
  EXPECT_EQ(outcome.duration, 5 * seconds(4));
  ASSERT_EQ(outcome.watched.size(), 5U);
  EXPECT_EQ(gaze_quality(outcome.watched).data_loss, 1.0);
  test::TestEyeTracker silent;
  const Outcome nothing = run(targets, eye, silent);
  EXPECT_EQ(nothing.duration, 5 * seconds(4));
  EXPECT_EQ(gaze_quality(nothing.watched).data_loss, 1.0);
}

// An offset of 0.8 degrees in azimuth and 0.6 in elevation is 1 degree, less off the horizon; with
// noise s of 0.1 on both axes, Rice's mean is s^2 / 2 more. What is left after the correction is
// noise: s sqrt(pi / 2), and of the fit, which is of 120 samples a target, hardly more.
TEST(Calibration, MeasuresATrackerAndCorrectsIt) {
  const std::vector<Vec3> targets = calibration_targets(9, 60.0, 60.0);
  SimulatedTrackerSettings settings{.rate_hz = 120.0,
                                    .latency_s = 0.014,
                                    .precision_deg = 0.1,
                                    .bias_right_deg = 0.8,
                                    .bias_up_deg = -0.6,
                                    .data_loss = 0.05,
                                    .seed = 11};
  ObedientEye eye;
  const GazeQuality before = gaze_quality(run(targets, eye, settings).watched);
  ASSERT_TRUE(before.figures);
  double offset_deg = 0.0;
  for (const Vec3& target : targets) {
    const double elevation_rad = azimuth_elevation(target).elevation_rad;
    offset_deg += std::hypot(0.8 * std::cos(elevation_rad), 0.6) / 9.0;
  }
  EXPECT_NEAR(before.figures->accuracy_deg, offset_deg + 0.005, 0.01);
  EXPECT_NEAR(before.figures->precision_rms_deg, 0.2, 0.01);
  EXPECT_NEAR(before.figures->precision_sd_deg, std::sqrt(2.0) * 0.1, 0.01);
  EXPECT_NEAR(before.data_loss, 0.05, 0.02);

  const auto correction = fit_correction(before.targets);
  ASSERT_TRUE(correction);
  settings.seed = 12;
  CorrectedEyeTracker tracker(std::make_unique<SimulatedEyeTracker>(
                                  settings, [&](Nanoseconds time) { return eye.gaze(time); }),
                              *correction);
  const GazeQuality after = gaze_quality(run(targets, eye, tracker).watched);
  EXPECT_NEAR(after.figures->accuracy_deg, 0.1 * std::sqrt(0.5 * std::numbers::pi), 0.01);
  EXPECT_NEAR(after.figures->precision_rms_deg, 0.2, 0.01);
}

}  // namespace

}  // namespace foveola
