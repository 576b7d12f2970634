#include "renderer/gaze/head_tracker.h"

#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

HeadPose pose_at(int time_ms, double azimuth_deg, double elevation_deg) {
  return {
      .time = milliseconds(time_ms),
      .heading = {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)}};
}

TEST(ScriptedHeadTracker, TurnsAtConstantSpeedBetweenPoses) {
  ScriptedHeadTracker tracker({pose_at(0, 0, 0), pose_at(100, 40, -20), pose_at(200, 40, 10)});
  EXPECT_NEAR(degrees(tracker.pose(milliseconds(25)).heading.azimuth_rad), 10.0, 1e-9);
  EXPECT_NEAR(degrees(tracker.pose(milliseconds(50)).heading.elevation_rad), -10.0, 1e-9);
  EXPECT_NEAR(degrees(tracker.pose(milliseconds(150)).heading.elevation_rad), -5.0, 1e-9);
  EXPECT_EQ(tracker.pose(milliseconds(150)).time, milliseconds(150));
}

TEST(ScriptedHeadTracker, StandsStillBeforeAndAfter) {
  ScriptedHeadTracker tracker({pose_at(50, 7, 0), pose_at(100, 9, 0)});
  EXPECT_NEAR(degrees(tracker.pose(milliseconds(0)).heading.azimuth_rad), 7.0, 1e-9);
  EXPECT_NEAR(degrees(tracker.pose(milliseconds(500)).heading.azimuth_rad), 9.0, 1e-9);
}

TEST(ScriptedHeadTracker, TurnsTheShortWayAcrossTheSeam) {
  ScriptedHeadTracker tracker({pose_at(0, 170, 0), pose_at(100, -170, 0)});
  const double middle_rad = tracker.pose(milliseconds(50)).heading.azimuth_rad;
  EXPECT_NEAR(std::cos(middle_rad), -1.0, 1e-12);
  EXPECT_NEAR(degrees(tracker.pose(milliseconds(75)).heading.azimuth_rad), -175.0, 1e-9);
  ScriptedHeadTracker back({pose_at(0, -170, 0), pose_at(100, 170, 0)});
  EXPECT_NEAR(degrees(back.pose(milliseconds(75)).heading.azimuth_rad), 175.0, 1e-9);
}

TEST(ScriptedHeadTracker, NeedsPosesInTheOrderOfTime) {
  EXPECT_THROW(ScriptedHeadTracker({}), Error);
  EXPECT_THROW(ScriptedHeadTracker({pose_at(10, 0, 0), pose_at(5, 0, 0)}), Error);
  EXPECT_THROW(ScriptedHeadTracker({pose_at(10, 0, 0), pose_at(10, 1, 0)}), Error);
}

TEST(ScriptedHeadTracker, TiltsAtConstantSpeed) {
  ScriptedHeadTracker tracker(
      {{.time = Nanoseconds(0)}, {.time = milliseconds(100), .roll_rad = radians(-30.0)}});
  EXPECT_NEAR(degrees(tracker.pose(milliseconds(50)).roll_rad), -15.0, 1e-9);
  EXPECT_NEAR(degrees(tracker.pose(milliseconds(500)).roll_rad), -30.0, 1e-9);
}

TEST(ScriptedHeadTracker, TiltsTheShortWayUpsideDown) {
  ScriptedHeadTracker tracker({{.time = Nanoseconds(0), .roll_rad = radians(170.0)},
                               {.time = milliseconds(100), .roll_rad = radians(-170.0)}});
  EXPECT_NEAR(degrees(tracker.pose(milliseconds(25)).roll_rad), 175.0, 1e-9);
}

TEST(HeadPose, OfAnOrientationLooksAndTiltsAsItDoes) {
  for (const double roll_deg : {-170.0, -20.0, 0.0, 33.0, 179.0}) {
    const AzimuthElevation heading{.azimuth_rad = -2.0, .elevation_rad = 0.6};
    const HeadPose pose = head_pose(milliseconds(3), head_orientation(heading, radians(roll_deg)));
    EXPECT_EQ(pose.time, milliseconds(3));
    EXPECT_NEAR(pose.heading.azimuth_rad, -2.0, 1e-6);
    EXPECT_NEAR(pose.heading.elevation_rad, 0.6, 1e-6);
    EXPECT_NEAR(degrees(pose.roll_rad), roll_deg, 0.5 * 360.0 / 65536.0 + 1e-4);
  }
}

TEST(HeadPose, TiltedToTheRightHasItsUpToTheRight) {
  const HeadPose pose{.roll_rad = radians(90.0)};
  EXPECT_LT(angle_between(pose.orientation() * Vec3(0, 1, 0), Vec3(1, 0, 0)), 1e-6);
  EXPECT_LT(angle_between(pose.orientation() * Vec3(0, 0, -1), Vec3(0, 0, -1)), 1e-6);
}

// Where looking up and turning are one.
TEST(HeadPose, OfAHeadThatLooksStraightUpIsTheSameOrientation) {
  const Quat up = glm::angleAxis(0.7F, Vec3(0, 1, 0)) *
                  head_orientation({.azimuth_rad = 0.0, .elevation_rad = radians(90.0)});
  const Quat again = head_pose({}, up).orientation();
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    EXPECT_LT(degrees(angle_between(up * axis, again * axis)), 0.01);
  }
}

TEST(SimulatedHeadTracker, FollowsTheHead) {
  SimulatedHeadTracker tracker(
      [](Nanoseconds time) { return AzimuthElevation{.azimuth_rad = foveola::seconds(time)}; });
  EXPECT_DOUBLE_EQ(tracker.pose(milliseconds(250)).heading.azimuth_rad, 0.25);
}

}  // namespace
}  // namespace foveola
