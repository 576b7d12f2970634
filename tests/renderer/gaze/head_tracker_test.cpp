#include "renderer/gaze/head_tracker.h"

#include <cmath>
#include <numbers>
#include <thread>

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

using std::chrono::milliseconds;

constexpr AzimuthElevation level_ahead{};

double azimuth_deg(SteeredHeadTracker& head, int time_ms) {
  return degrees(head.pose(milliseconds(time_ms)).heading.azimuth_rad);
}

double elevation_deg(SteeredHeadTracker& head, int time_ms) {
  return degrees(head.pose(milliseconds(time_ms)).heading.elevation_rad);
}

TurnSpeed speed_deg(double right_deg_per_s, double up_deg_per_s) {
  return {.right_rad_per_s = radians(right_deg_per_s), .up_rad_per_s = radians(up_deg_per_s)};
}

Turn turn_deg(double right_deg, double up_deg) {
  return {.right_rad = radians(right_deg), .up_rad = radians(up_deg)};
}

TEST(SteeredHeadTracker, DragsTurnItAtOnce) {
  SteeredHeadTracker head(level_ahead);
  head.turn(milliseconds(10), turn_deg(5.0, 2.0));
  head.turn(milliseconds(12), turn_deg(-8.0, 1.0));
  EXPECT_NEAR(azimuth_deg(head, 12), -3.0, 1e-12);
  EXPECT_NEAR(elevation_deg(head, 500), 3.0, 1e-12);
}

TEST(SteeredHeadTracker, AHeldKeyTurnsItByItsSpeedTimesHowLong) {
  SteeredHeadTracker head(level_ahead);
  head.set_speed(milliseconds(1000), speed_deg(40.0, -20.0));
  EXPECT_NEAR(azimuth_deg(head, 1250), 10.0, 1e-12);
  EXPECT_NEAR(elevation_deg(head, 1250), -5.0, 1e-12);
  head.set_speed(milliseconds(1600), {});
  EXPECT_NEAR(azimuth_deg(head, 1600), 24.0, 1e-12);
  EXPECT_NEAR(azimuth_deg(head, 9000), 24.0, 1e-12);
  EXPECT_NEAR(elevation_deg(head, 9000), -12.0, 1e-12);
}

TEST(SteeredHeadTracker, FramesDoNotChangeHowFarItTurns) {
  const auto azimuth_with_frames_every = [](int frame_ms) {
    SteeredHeadTracker head(level_ahead);
    head.set_speed(milliseconds(1003), speed_deg(33.3, 0.0));
    for (int time_ms = 1003; time_ms < 1791; time_ms += frame_ms) {
      head.pose(milliseconds(time_ms));
    }
    head.set_speed(milliseconds(1791), {});
    return head.pose(milliseconds(2000)).heading.azimuth_rad;
  };
  EXPECT_EQ(azimuth_with_frames_every(1), azimuth_with_frames_every(300));
  EXPECT_EQ(azimuth_with_frames_every(14), azimuth_with_frames_every(300));
}

TEST(SteeredHeadTracker, AFrameThatIsBeforeTheNewsIsMadeGood) {
  SteeredHeadTracker head(level_ahead);
  head.set_speed(milliseconds(0), speed_deg(100.0, 0.0));
  EXPECT_NEAR(azimuth_deg(head, 110), 11.0, 1e-12) << "not known yet that the key is up";
  head.set_speed(milliseconds(100), {});
  EXPECT_NEAR(azimuth_deg(head, 110), 10.0, 1e-12);
}

TEST(SteeredHeadTracker, WhatComesLateCountsAsTheLastOnesTime) {
  SteeredHeadTracker head(level_ahead);
  head.set_speed(milliseconds(100), speed_deg(10.0, 0.0));
  head.set_speed(milliseconds(90), speed_deg(-10.0, 0.0));
  EXPECT_NEAR(azimuth_deg(head, 200), -1.0, 1e-12);
  EXPECT_NEAR(azimuth_deg(head, 50), 0.0, 1e-12) << "nothing is known of before";
}

TEST(SteeredHeadTracker, DragsAddToAHeldKey) {
  SteeredHeadTracker head(level_ahead);
  head.set_speed(milliseconds(0), speed_deg(10.0, 0.0));
  head.turn(milliseconds(500), turn_deg(20.0, 0.0));
  EXPECT_NEAR(azimuth_deg(head, 500), 25.0, 1e-12);
  EXPECT_NEAR(azimuth_deg(head, 1000), 30.0, 1e-12);
}

TEST(SteeredHeadTracker, TheAzimuthGoesRound) {
  SteeredHeadTracker head({.azimuth_rad = radians(170.0)});
  head.turn(milliseconds(0), turn_deg(20.0, 0.0));
  EXPECT_NEAR(azimuth_deg(head, 0), -170.0, 1e-9);
  head.set_speed(milliseconds(0), speed_deg(-90.0, 0.0));
  EXPECT_NEAR(azimuth_deg(head, 8000), -170.0, 1e-9) << "two turns";
}

TEST(SteeredHeadTracker, TheElevationStopsAtTheZenithAndLeavesItWithoutDelay) {
  SteeredHeadTracker head(level_ahead);
  head.set_speed(milliseconds(0), speed_deg(0.0, 60.0));
  EXPECT_EQ(head.pose(milliseconds(5000)).heading.elevation_rad, 0.5 * std::numbers::pi);
  head.set_speed(milliseconds(5000), speed_deg(0.0, -60.0));
  EXPECT_NEAR(elevation_deg(head, 5500), 60.0, 1e-12);
  head.turn(milliseconds(5500), turn_deg(0.0, -500.0));
  EXPECT_EQ(head.pose(milliseconds(5500)).heading.elevation_rad, -0.5 * std::numbers::pi);
}

// For the thread sanitizer, and that no turn is lost.
TEST(SteeredHeadTracker, IsSteeredWhileFramesLook) {
  SteeredHeadTracker head(level_ahead);
  constexpr int turns = 2000;
  std::thread steering([&] {
    for (int i = 0; i < turns; ++i) {
      head.turn(Nanoseconds(i), {.right_rad = 0x1p-11, .up_rad = 0.0});
    }
  });
  double farthest_rad = 0.0;
  for (int i = 0; i < turns; ++i) {
    const double azimuth_rad = head.pose(Nanoseconds(turns)).heading.azimuth_rad;
    EXPECT_GE(azimuth_rad, farthest_rad);
    farthest_rad = azimuth_rad;
  }
  steering.join();
  EXPECT_EQ(head.pose(Nanoseconds(turns)).heading.azimuth_rad, turns * 0x1p-11);
}

}  // namespace

}  // namespace foveola
