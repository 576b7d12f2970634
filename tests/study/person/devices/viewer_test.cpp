#include "study/person/devices/viewer.h"

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

constexpr Vec3 ahead{0.0F, 0.0F, -1.0F};

/// The angle in degrees between where the head is turned and a direction.
double degrees_off(Viewer& viewer, Nanoseconds time, const Vec3& direction) {
  return degrees(angle_between(viewer.orientation(time) * ahead, direction));
}

WindowEvent key_moved(Nanoseconds time, bool is_down) {
  return {.time = time, .what = KeyMoved{.key = GLFW_KEY_RIGHT, .is_down = is_down}};
}

TEST(ViewerTest, LooksAlongItsHeadingAndTurnsToWhatIsAsked) {
  Viewer viewer(nullptr);
  EXPECT_NEAR(degrees_off(viewer, 0s, ahead), 0.0, 1e-3);
  const AzimuthElevation heading{.azimuth_rad = radians(170.0), .elevation_rad = radians(20.0)};
  viewer.look_along(heading);
  EXPECT_NEAR(degrees_off(viewer, 0s, direction_from(heading)), 0.0, 1e-3);
  const Vec3 beyond_the_seam =
      direction_from({.azimuth_rad = radians(-150.0), .elevation_rad = radians(-40.0)});
  viewer.turn_to(beyond_the_seam, 1s);
  EXPECT_NEAR(degrees_off(viewer, 1s, beyond_the_seam), 0.0, 1e-2);
}

TEST(ViewerTest, AHeadThatIsTrackedIsNotTurnedByKeys) {
  const AzimuthElevation heading{.azimuth_rad = 0.5, .elevation_rad = 0.1};
  SimulatedHeadTracker worn([&](Nanoseconds) { return heading; });
  Viewer viewer(nullptr, &worn);
  viewer.look_along({.azimuth_rad = 2.0});
  viewer.follow(key_moved(0s, true), true);
  EXPECT_NEAR(degrees_off(viewer, 1s, direction_from(heading)), 0.0, 1e-3);
}

TEST(ViewerTest, KeysTurnItOnlyWhereThePictureIsSeen) {
  Viewer viewer(nullptr);
  viewer.follow(key_moved(0s, true), false);
  EXPECT_NEAR(degrees_off(viewer, 1s, ahead), 0.0, 1e-3);
  viewer.follow(key_moved(1s, false), false);
  viewer.follow(key_moved(2s, true), true);
  EXPECT_GT(degrees_off(viewer, 3s, ahead), 10.0);
}

TEST(ViewerTest, WhatWasHeldMayBeLetGoBelowAPage) {
  Viewer viewer(nullptr);
  viewer.follow(key_moved(0s, true), true);
  viewer.follow(key_moved(1s, false), false);
  const Vec3 then = viewer.orientation(1s) * ahead;
  EXPECT_NEAR(degrees_off(viewer, 5s, then), 0.0, 1e-3);
}

TEST(ViewerTest, ANewHeadingEndsWhatWasHeld) {
  Viewer viewer(nullptr);
  viewer.follow(key_moved(0s, true), true);
  viewer.look_along({});
  EXPECT_NEAR(degrees_off(viewer, 9s, ahead), 0.0, 1e-3);
}

TEST(ViewerTest, ThePointersPlaceGoesByTheWindowsPixelsAfterANewHeading) {
  PointerEyeTracker pointer;
  Viewer viewer(&pointer);
  // A pane of 40 by 40 degrees on 400 x 400 pixels, of which the window's coordinates count half.
  viewer.show({.horizontal_fov_deg = 40.0,
               .vertical_fov_deg = 40.0,
               .parts = {{.origin = {0, 0}, .size = {400, 400}}}},
              {400, 400}, 2.0);
  viewer.look_along({});
  viewer.follow({.time = 1s, .what = PointerMoved{.is_inside = true, .position = {200.0, 100.0}}},
                false);
  std::vector<GazeSample> arrived;
  pointer.poll(1s, arrived);
  ASSERT_FALSE(arrived.empty());
  EXPECT_NEAR(degrees(azimuth_elevation(arrived.back().direction).azimuth_rad), 20.0, 1e-3);
}

}  // namespace
}  // namespace foveola::study
