#include "renderer/window/live/steering.h"

#include <gmock/gmock.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace foveola {
namespace {

using std::chrono::milliseconds;

/// A monitor's window of 1000x500 pixels, as wide as it is seen under 90 degrees.
class SteeringTest : public ::testing::Test {
 protected:
  SteeringTest() {
    const DisplayProfile display{.kind = DisplayKind::monitor,
                                 .width_px = 1000,
                                 .height_px = 500,
                                 .refresh_rate_hz = 60.0,
                                 .width_m = 1.0,
                                 .height_m = 0.5,
                                 .viewing_distance_m = 0.5};
    steering_.show(view_geometry(display, {1000, 500}), {1000, 500}, 1.0);
  }

  void at(int time_ms, decltype(WindowEvent::what) what) {
    steering_.follow({.time = milliseconds(time_ms), .what = std::move(what)});
  }
  AzimuthElevation heading(int time_ms) { return head_.pose(milliseconds(time_ms)).heading; }

  SteeredHeadTracker head_{AzimuthElevation{}};
  PointerEyeTracker gaze_;
  Steering steering_{head_, &gaze_};
};

TEST_F(SteeringTest, AHeldKeyTurnsTheHeadForAsLongAsItIsHeld) {
  at(100, KeyMoved{.key = GLFW_KEY_RIGHT, .is_down = true});
  at(600, KeyMoved{.key = GLFW_KEY_RIGHT, .is_down = false});
  EXPECT_NEAR(degrees(heading(900).azimuth_rad), 30.0, 1e-9);  // 60 degrees a second
  EXPECT_NEAR(heading(900).elevation_rad, 0.0, 1e-12);
}

TEST_F(SteeringTest, ThePictureFollowsAPointerThatDragsIt) {
  at(0, PointerMoved{.is_inside = true, .position = {500, 250}});
  at(1, PointerMoved{.is_inside = true, .position = {400, 250}});
  EXPECT_EQ(heading(1).azimuth_rad, 0.0);
  at(2, MouseButtonMoved{.button = GLFW_MOUSE_BUTTON_LEFT, .is_down = true});
  at(3, PointerMoved{.is_inside = true, .position = {500, 200}});
  at(4, MouseButtonMoved{.button = GLFW_MOUSE_BUTTON_LEFT, .is_down = false});
  at(5, PointerMoved{.is_inside = true, .position = {900, 200}});
  EXPECT_NEAR(degrees(heading(5).azimuth_rad), -9.0, 1e-9);  // a tenth of the view to the left
  EXPECT_NEAR(degrees(heading(5).elevation_rad), -4.5, 1e-9);
}

TEST_F(SteeringTest, ThePointerIsTheGaze) {
  at(10, PointerMoved{.is_inside = true, .position = {1000, 250}});
  ASSERT_TRUE(steering_.pointer());
  EXPECT_NEAR(glm::length(*steering_.pointer() - glm::normalize(Vec3(1, 0, -1))), 0.0, 1e-6);
  std::vector<GazeSample> arrived;
  gaze_.poll(milliseconds(20), arrived);
  ASSERT_FALSE(arrived.empty());
  EXPECT_TRUE(arrived.back().valid);
  EXPECT_NEAR(glm::length(arrived.back().direction - *steering_.pointer()), 0.0, 1e-6);
  at(30, PointerMoved{.is_inside = false});
  EXPECT_FALSE(steering_.pointer());
  gaze_.poll(milliseconds(40), arrived);
  EXPECT_FALSE(arrived.back().valid);
}

TEST_F(SteeringTest, ASticksPushTurnsTheHead) {
  at(0, GamepadMoved{.sticks = {.right = {1.0, 0.0}}});
  at(1000, GamepadMoved{});
  const double turned = heading(1500).azimuth_rad;
  EXPECT_NEAR(turned, StickResponse{}.full_speed_rad_per_s, 1e-9);
}

}  // namespace
}  // namespace foveola
