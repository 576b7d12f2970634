#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/window/live/window_gaze.h"

namespace foveola {
namespace {

/// 0.25 mm a pixel, seen from half a metre.
const DisplayProfile watched_monitor{.kind = DisplayKind::monitor,
                                     .width_px = 1920,
                                     .height_px = 1080,
                                     .horizontal_fov_deg = 2.0 * degrees(std::atan(0.24 / 0.5)),
                                     .vertical_fov_deg = 2.0 * degrees(std::atan(0.135 / 0.5)),
                                     .width_m = 0.48,
                                     .height_m = 0.27,
                                     .viewing_distance_m = 0.5};

/// What a tracker tells of an eye that looks at a fraction of the monitor, seen in the window.
GazeSample seen(const DVec2& fraction, const std::optional<WindowPlace>& place) {
  PlacedEyeTracker eye(
      std::make_unique<FixedEyeTracker>(direction_at(screen_of(watched_monitor), fraction)),
      watched_monitor, [&] { return place; });
  std::vector<GazeSample> arrived = {{.direction = Vec3(1.0F, 0.0F, 0.0F), .valid = true}};
  eye.poll(Nanoseconds(1), arrived);
  EXPECT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived.front().direction, Vec3(1.0F, 0.0F, 0.0F)) << "it came before";
  EXPECT_EQ(eye.status().empty(), place.has_value());
  return arrived.back();
}

void expect_tangents(const GazeSample& sample, double right, double up) {
  ASSERT_TRUE(sample.valid);
  EXPECT_NEAR(sample.direction.x / -sample.direction.z, right, 1e-6);
  EXPECT_NEAR(sample.direction.y / -sample.direction.z, up, 1e-6);
}

TEST(PlacedEyeTracker, AWindowThatFillsTheMonitorChangesNothing) {
  expect_tangents(seen({1.0, 0.0}, WindowPlace{.monitor_px = {1920, 1080}}), 0.24 / 0.5,
                  0.135 / 0.5);
}

// A window of 640 x 480 in the top left corner: its middle is 320 and 240 pixels from there.
TEST(PlacedEyeTracker, AWindowInACornerHasItsMiddleAhead) {
  const WindowPlace corner{.monitor_px = {1920, 1080}, .centre_px = {320.0 - 960.0, 240.0 - 540.0}};
  expect_tangents(seen({320.0 / 1920.0, 240.0 / 1080.0}, corner), 0.0, 0.0);
  expect_tangents(seen({0.0, 0.0}, corner), -320 * 0.25e-3 / 0.5, 240 * 0.25e-3 / 0.5);
  expect_tangents(seen({0.5, 0.5}, corner), 640 * 0.25e-3 / 0.5, -300 * 0.25e-3 / 0.5);
}

// The view has the profile's pixels, of which this monitor has twice as many.
TEST(PlacedEyeTracker, GoesByThePixelsThatThereAre) {
  const WindowPlace larger{.monitor_px = {3840, 2160}};
  expect_tangents(seen({1.0, 0.5}, larger), 1920 * 0.25e-3 / 0.5, 0.0);
}

TEST(PlacedEyeTracker, WhatCannotBeKnownIsNoGaze) { EXPECT_FALSE(seen({0.5, 0.5}, {}).valid); }

}  // namespace
}  // namespace foveola
