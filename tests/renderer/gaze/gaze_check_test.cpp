#include "renderer/gaze/gaze_check.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/gaze/calibration_routine.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

constexpr double off_right_deg = 1.2;
constexpr double off_up_deg = -0.8;

/// Sees every gaze beside where it is, 100 times a second.
class OffsetTracker final : public EyeTracker {
 public:
  explicit OffsetTracker(const Vec3* gaze) : gaze_(gaze) {}
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override {
    const AzimuthElevation angles = azimuth_elevation(*gaze_);
    for (; next_ <= now; next_ += milliseconds(10)) {
      arrived.push_back({.time = next_,
                         .direction = direction_from(
                             {.azimuth_rad = angles.azimuth_rad + radians(off_right_deg),
                              .elevation_rad = angles.elevation_rad + radians(off_up_deg)}),
                         .valid = true});
    }
  }

 private:
  const Vec3* gaze_;
  Nanoseconds next_{0};
};

class GazeCheckTest : public testing::Test {
 protected:
  /// Someone who looks at each target as long as it is there.
  std::vector<WatchedTarget> look_at_targets() {
    CalibrationRoutine routine(calibration_targets(5, 60.0, 40.0), {}, now_);
    while (const std::optional<Vec3> target = routine.target()) {
      gaze_ = *target;
      now_ += milliseconds(10);
      std::vector<GazeSample> arrived;
      tracker_.poll(now_, arrived);
      routine.update(now_, arrived);
    }
    return routine.watched();
  }

  Nanoseconds now_{0};
  Vec3 gaze_{0.0F, 0.0F, -1.0F};
  CorrectedEyeTracker tracker_{std::make_unique<OffsetTracker>(&gaze_)};
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
