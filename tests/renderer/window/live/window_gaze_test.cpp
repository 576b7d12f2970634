#include "renderer/window/live/window_gaze.h"

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

using std::chrono::seconds;

class TrackerCheckTest : public ::testing::Test {
 protected:
  /// Each dot is given up 4 s after it appeared: nobody looks.
  std::optional<std::vector<WatchedTarget>> wait(int until_s) {
    return check_.update(seconds(until_s), {});
  }

  ViewGeometry geometry_{.horizontal_fov_deg = 40.0, .vertical_fov_deg = 20.0};
  TrackerCheck check_;
};

TEST_F(TrackerCheckTest, ShowsOneDotAfterTheOther) {
  EXPECT_FALSE(check_.is_running());
  check_.begin(geometry_, {}, seconds(0));
  EXPECT_THAT(check_.panel().lines,
              ElementsAre("Look at the dot: 1 of 5", "Escape ends the check"));
  const Quat head = head_orientation({.azimuth_rad = radians(90.0)});
  const Vec3 first = *check_.overlays(head).target;
  EXPECT_NEAR(glm::distance(first, Vec3(1.0F, 0.0F, 0.0F)), 0.0, 1e-6) << "in the view's middle";
  EXPECT_FALSE(wait(5));
  EXPECT_THAT(check_.panel().lines.front(), "Look at the dot: 2 of 5");
  EXPECT_NE(*check_.overlays(head).target, first);
  for (const int until_s : {10, 15, 20}) {
    EXPECT_FALSE(wait(until_s));
  }
  EXPECT_TRUE(check_.is_running());
  const auto watched = wait(25);
  ASSERT_TRUE(watched);
  EXPECT_THAT(*watched, SizeIs(5));
  EXPECT_FALSE(check_.is_running());
  EXPECT_FALSE(wait(30));
}

TEST_F(TrackerCheckTest, BeginsAnewOrEndsEarly) {
  check_.begin(geometry_, {}, seconds(0));
  wait(5);
  check_.begin(geometry_, {}, seconds(6));
  EXPECT_THAT(check_.panel().lines.front(), "Look at the dot: 1 of 5");
  check_.end();
  EXPECT_FALSE(check_.is_running());
  EXPECT_FALSE(wait(60));
}

Vec3 seen(const Vec3& direction, double times) {
  FixedEyeTracker fixed(direction);
  WidenedEyeTracker eye(fixed);
  eye.widen(times);
  std::vector<GazeSample> arrived = {{.direction = Vec3(1.0F, 0.0F, 0.0F), .valid = true}};
  eye.poll(Nanoseconds(1), arrived);
  EXPECT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived.front().direction, Vec3(1.0F, 0.0F, 0.0F)) << "it came before";
  return arrived.back().direction;
}

TEST(WidenedEyeTrackerTest, GoesFartherOnThePlaneBeforeTheEye) {
  const Vec3 widened = seen(glm::normalize(Vec3(0.1F, -0.2F, -1.0F)), 3.0);
  EXPECT_NEAR(glm::length(widened - glm::normalize(Vec3(0.3F, -0.6F, -1.0F))), 0.0, 1e-6);
}

TEST(WidenedEyeTrackerTest, LeavesTrueAnglesToTheBit) {
  const Vec3 direction = glm::normalize(Vec3(0.123F, -0.234F, -1.0F));
  EXPECT_EQ(seen(direction, 1.0), direction);
}

TEST(WidenedEyeTrackerTest, WhatLiesBehindStays) {
  const Vec3 direction = glm::normalize(Vec3(0.5F, 0.0F, 1.0F));
  EXPECT_EQ(seen(direction, 2.0), direction);
}

}  // namespace

}  // namespace foveola
