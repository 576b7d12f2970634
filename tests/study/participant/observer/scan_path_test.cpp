#include "study/participant/observer/scan_path.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "study/participant/population_file.h"

namespace foveola::study {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const GazeHabits gaze_habits = read_people("adults").population.gaze;
const Vec3 looked_for = direction_from({.azimuth_rad = 0.7, .elevation_rad = -0.2});
constexpr double object_radius_deg = 6.0;

double head_offset_deg(const AzimuthElevation& head, const Vec3& direction) {
  return degrees(angle_between(direction_from(head), direction));
}

TEST(ScanPath, KeepsTheEyeOnTheExaminedObjectAndTheHeadFacingIt) {
  ScanPath path(gaze_habits, 3);
  path.examine(looked_for, object_radius_deg, seconds(2));
  for (Nanoseconds time = seconds(3); time < seconds(20); time += milliseconds(5)) {
    EXPECT_LT(degrees(angle_between(path.gaze(time), looked_for)), object_radius_deg);
    EXPECT_LT(head_offset_deg(path.head(time), looked_for), 0.01);
  }
}

TEST(ScanPath, GoesToATargetAndStaysWhileTheHeadDoesNotMove) {
  ScanPath path(gaze_habits, 6);
  path.examine(looked_for, object_radius_deg, Nanoseconds(0));
  const Nanoseconds start = seconds(5);
  const AzimuthElevation head = path.head(start);
  const Vec3 before = path.gaze(start);
  const Vec3 target = direction_from({.azimuth_rad = 0.9, .elevation_rad = 0.1});
  path.fixate(target, start);
  for (Nanoseconds time = start; time < seconds(15); time += milliseconds(5)) {
    const double since_s = std::chrono::duration<double>(time - start).count();
    if (since_s < gaze_habits.saccade_latency_s) {
      EXPECT_LT(degrees(angle_between(path.gaze(time), before)), 1e-3);
    } else if (since_s > gaze_habits.saccade_latency_s + 0.1) {
      EXPECT_LT(degrees(angle_between(path.gaze(time), target)), 1e-3);
    }
    EXPECT_LT(head_offset_deg(path.head(time), direction_from(head)), 1e-3);
  }
}

TEST(ScanPath, FixatesForFractionsOfASecondAndMovesInBetween) {
  ScanPath path(gaze_habits, 4);
  path.examine(looked_for, object_radius_deg, Nanoseconds(0));
  // The lengths of the stretches during which the eye stands still, at 1 ms.
  std::vector<int> fixations_ms;
  int still_ms = 0;
  for (Nanoseconds time = seconds(1); time < seconds(30); time += milliseconds(1)) {
    if (path.gaze(time) == path.gaze(time + milliseconds(1))) {
      ++still_ms;
    } else if (still_ms > 0) {
      fixations_ms.push_back(still_ms);
      still_ms = 0;
    }
  }
  ASSERT_GT(fixations_ms.size(), 29 / (gaze_habits.longest_fixation_s + 0.05));
  // The first one may have begun before we looked.
  const auto [shortest, longest] =
      std::minmax_element(fixations_ms.begin() + 1, fixations_ms.end());
  EXPECT_GE(*shortest, 1e3 * gaze_habits.shortest_fixation_s - 2.0);
  EXPECT_LE(*longest, 1e3 * gaze_habits.longest_fixation_s + 2.0);
}

TEST(ScanPath, LooksAroundWithHeadAndEyeWithinReach) {
  ScanPath path(gaze_habits, 5);
  path.explore(3.0, Nanoseconds(0));
  double leftmost_deg = 0.0;
  double rightmost_deg = 0.0;
  double highest_deg = 0.0;
  // After the first turn of the head, which may start from anywhere.
  for (Nanoseconds time = seconds(2); time < seconds(60); time += milliseconds(20)) {
    const AzimuthElevation head = path.head(time);
    const double offset_deg =
        degrees(std::remainder(head.azimuth_rad - 3.0, 2.0 * std::numbers::pi));
    leftmost_deg = std::min(leftmost_deg, offset_deg);
    rightmost_deg = std::max(rightmost_deg, offset_deg);
    highest_deg = std::max(highest_deg, std::abs(degrees(head.elevation_rad)));
  }
  EXPECT_LT(leftmost_deg, -90.0) << "all around";
  EXPECT_GT(rightmost_deg, 90.0);
  EXPECT_GT(highest_deg, 5.0);
  EXPECT_LE(highest_deg, gaze_habits.head_elevation_deg + 0.01) << "about the horizon";
}

/// The eye cannot turn far in the head, so that it arrives with it, however far both go.
TEST(ScanPath, TheHeadCarriesTheEyeAlong) {
  ScanPath path(gaze_habits, 11);
  path.explore(0.0, Nanoseconds(0));
  for (Nanoseconds time = seconds(1); time < seconds(60); time += milliseconds(5)) {
    EXPECT_LT(head_offset_deg(path.head(time), path.gaze(time)), 6.0 * gaze_habits.eye_in_head_deg);
  }
}

TEST(ScanPath, NeverJumps) {
  ScanPath path(gaze_habits, 6);
  path.examine(looked_for, object_radius_deg, Nanoseconds(0));
  path.gaze(seconds(3));
  path.explore(azimuth_elevation(looked_for).azimuth_rad, seconds(3));
  const Nanoseconds end = seconds(10);
  constexpr auto step = milliseconds(1);
  for (Nanoseconds time = seconds(3); time < end; time += step) {
    // The fastest saccades reach about 700 degrees per second; ours are eased with a peak of 1.5
    // times the mean speed, which tends to 1 / 2.2 degrees per millisecond.
    EXPECT_LT(degrees(angle_between(path.gaze(time), path.gaze(time + step))), 1.0);
    EXPECT_LT(head_offset_deg(path.head(time), direction_from(path.head(time + step))), 1.0);
  }
}

TEST(ScanPath, IsTheSameHoweverOftenItIsAsked) {
  ScanPath often(gaze_habits, 7);
  ScanPath seldom(gaze_habits, 7);
  ScanPath other(gaze_habits, 8);
  for (ScanPath* path : {&often, &seldom, &other}) {
    path->explore(0.0, Nanoseconds(0));
  }
  for (Nanoseconds time{0}; time < seconds(9); time += milliseconds(3)) {
    often.gaze(time);
  }
  EXPECT_EQ(often.gaze(seconds(9)), seldom.gaze(seconds(9)));
  EXPECT_NE(often.gaze(seconds(9)), other.gaze(seconds(9)));
  EXPECT_EQ(often.gaze(seconds(4)), seldom.gaze(seconds(4)));
}

TEST(ScanPath, FixationsFollowOneAnotherWithoutAGapAndAreWhatTheGazeDoes) {
  ScanPath path(gaze_habits, 9);
  ScanPath watched(gaze_habits, 9);
  for (ScanPath* each : {&path, &watched}) {
    each->examine(looked_for, object_radius_deg, seconds(1));
  }
  path.gaze(seconds(30));  // The first half is looked up, the second is extended on demand.
  ScanPath::Fixation fixation = path.fixation(seconds(1));
  for (int i = 0; i < 200; ++i) {
    const ScanPath::Fixation next = path.fixation(fixation.end);
    EXPECT_EQ(next.begin, fixation.end);
    EXPECT_LT(next.begin, next.landing);
    EXPECT_LT(next.landing, next.end);
    EXPECT_EQ(watched.gaze(next.landing), next.direction);
    EXPECT_EQ(watched.gaze(next.end - Nanoseconds(1)), next.direction);
    EXPECT_NE(watched.gaze(next.end + milliseconds(20)), next.direction);
    fixation = next;
  }
}

TEST(ScanPath, WhatIsFixatedIsFixatedForEver) {
  ScanPath path(gaze_habits, 9);
  path.fixate(looked_for, seconds(1));
  const ScanPath::Fixation waiting = path.fixation(seconds(1));
  const ScanPath::Fixation fixation = path.fixation(waiting.end);
  EXPECT_EQ(fixation.direction, looked_for);
  EXPECT_EQ(fixation.end, Nanoseconds::max());
}

}  // namespace
}  // namespace foveola::study
