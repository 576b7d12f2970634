#include "study/stage/object_sight.h"

#include <chrono>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "study/record/read/attempt_gaze_figures.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

AzimuthElevation place(double azimuth_deg, double elevation_deg) {
  return {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)};
}

OfferedObject object_at(double azimuth_deg, double elevation_deg) {
  return {.direction = direction_from(place(azimuth_deg, elevation_deg)), .radius_deg = 4.0};
}

/// 40 degrees wide and 30 high.
Viewport view_along(double azimuth_deg) {
  return {place(azimuth_deg, 0.0), {.horizontal_deg = 40.0, .vertical_deg = 30.0}};
}

TEST(ObjectSight, AnObjectIsInViewUpToTheEdges) {
  EXPECT_TRUE(object_sight(view_along(0.0), object_at(19.5, 0.0)).is_in_view);
  EXPECT_FALSE(object_sight(view_along(0.0), object_at(20.5, 0.0)).is_in_view);
  EXPECT_TRUE(object_sight(view_along(0.0), object_at(0.0, -14.5)).is_in_view);
  EXPECT_FALSE(object_sight(view_along(0.0), object_at(0.0, -15.5)).is_in_view);
  EXPECT_FALSE(object_sight(view_along(0.0), object_at(180.0, 0.0)).is_in_view);
}

TEST(ObjectSight, TheAngleIsFromTheViewsMiddleAcrossTheSeam) {
  EXPECT_NEAR(object_sight(view_along(170.0), object_at(-175.0, 0.0)).from_middle_deg, 15.0, 1e-3);
  EXPECT_NEAR(object_sight(view_along(0.0), object_at(180.0, 0.0)).from_middle_deg, 180.0, 1e-3);
}

TEST(LookingTimes, AFramesTimeCountsForWhereItsGazeIs) {
  const auto frame = [](double azimuth_deg) {
    return FrameRow{.gaze = direction_from(place(azimuth_deg, 0.0)), .gaze_valid = true};
  };
  const double edge_deg = 4.0 + gaze_margin_deg;
  LookingTimes times;
  times.add(frame(edge_deg - 0.1), 1s, object_at(0.0, 0.0));
  times.add(frame(edge_deg + 0.1), 2s, object_at(0.0, 0.0));
  times.add({}, 1s, object_at(0.0, 0.0));
  EXPECT_EQ(times.on_object, 1s);
  EXPECT_DOUBLE_EQ(times.part_elsewhere(), 0.5);
  EXPECT_DOUBLE_EQ(times.part_unknown(), 0.25);
  EXPECT_EQ(LookingTimes{}.part_elsewhere(), 0.0);
}

}  // namespace
}  // namespace foveola::study
