#include "renderer/gaze/screen.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/renderer/gaze/gaze_expectations.h"

namespace foveola {
namespace {

// A screen of 0.6 m x 0.3 m that is seen from 0.3 m fills 90 degrees and 53.13 degrees.
constexpr Screen near_screen{.width_m = 0.6,
                             .height_m = 0.3,
                             .horizontal_fov_deg = 90.0,
                             .vertical_fov_deg = 53.13010235415598};

TEST(Screen, ItsMiddleIsAhead) { expect_along(direction_at(near_screen, {0.5, 0.5}), {0, 0, -1}); }

TEST(Screen, ItsCornersAreAtTheViewsEdges) {
  expect_along(direction_at(near_screen, {0.0, 0.0}), {-0.3F, 0.15F, -0.3F});
  expect_along(direction_at(near_screen, {1.0, 1.0}), {0.3F, -0.15F, -0.3F});
}

TEST(Screen, GoesOnBeyondItsEdges) {
  expect_along(direction_at(near_screen, {1.5, 0.5}), {0.6F, 0.0F, -0.3F});
}

TEST(Screen, MetresAreFromTheTopLeft) {
  const DVec2 fraction = fraction_of(near_screen, {0.15, 0.225});
  EXPECT_DOUBLE_EQ(fraction.x, 0.25);
  EXPECT_DOUBLE_EQ(fraction.y, 0.75);
}

}  // namespace
}  // namespace foveola
