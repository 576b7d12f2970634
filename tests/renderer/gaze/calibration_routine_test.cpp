#include "renderer/gaze/calibration_routine.h"

#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"
#include "renderer/gaze/gaze_correction.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/test_eye_tracker.h"

namespace foveola {
namespace {

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
