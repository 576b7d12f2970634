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

TEST(SimulatedHeadTracker, FollowsTheHead) {
  SimulatedHeadTracker tracker(
      [](Nanoseconds time) { return AzimuthElevation{.azimuth_rad = foveola::seconds(time)}; });
  EXPECT_DOUBLE_EQ(tracker.pose(milliseconds(250)).heading.azimuth_rad, 0.25);
}

}  // namespace
}  // namespace foveola
