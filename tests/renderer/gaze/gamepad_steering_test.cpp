#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "renderer/gaze/head_tracker.h"

namespace foveola {
namespace {

/// From a fifth of the way on, to the end, as the square.
constexpr StickResponse response{
    .dead_zone = 0.2, .full_push = 1.0, .exponent = 2.0, .full_speed_rad_per_s = 3.0};

DVec2 speed(const GamepadSticks& sticks) {
  const TurnSpeed turn = turn_speed(sticks, response);
  return {turn.right_rad_per_s, turn.up_rad_per_s};
}

/// The right stick, pushed so far, `angle_deg` above its right.
DVec2 pushed(double part, double angle_deg) {
  return {part * std::cos(radians(angle_deg)), -part * std::sin(radians(angle_deg))};
}

TEST(GamepadSteering, SticksAtRestDoNotTurn) {
  EXPECT_EQ(glm::length(speed({})), 0.0);
  for (int angle_deg = 0; angle_deg < 360; angle_deg += 15) {
    EXPECT_EQ(glm::length(speed({.right = pushed(0.199, angle_deg)})), 0.0) << angle_deg;
  }
}

TEST(GamepadSteering, TheResponseIsAPowerOfWhatIsLeftOfTheWay) {
  EXPECT_NEAR(speed({.right = {0.6, 0.0}}).x, 3.0 * 0.25, 1e-12);
  EXPECT_NEAR(speed({.right = {-0.6, 0.0}}).x, -3.0 * 0.25, 1e-12);
  EXPECT_NEAR(speed({.right = {0.4, 0.0}}).x, 3.0 * 0.0625, 1e-12);
  EXPECT_NEAR(speed({.right = {1.0, 0.0}}).x, 3.0, 1e-12);
}

TEST(GamepadSteering, UpIsUp) {
  EXPECT_NEAR(speed({.right = {0.0, -1.0}}).y, 3.0, 1e-12);
  EXPECT_NEAR(speed({.right = {0.0, 0.6}}).y, -3.0 * 0.25, 1e-12);
}

// A dead zone for each axis would bend directions towards the axes.
TEST(GamepadSteering, TheHeadTurnsAlongThePush) {
  for (int angle_deg = 0; angle_deg < 360; angle_deg += 10) {
    for (const double part : {0.25, 0.6, 1.0}) {
      const DVec2 turn = speed({.right = pushed(part, angle_deg)});
      EXPECT_NEAR(std::remainder(degrees(std::atan2(turn.y, turn.x)) - angle_deg, 360.0), 0.0,
                  1e-9);
      EXPECT_NEAR(glm::length(turn), speed({.right = {part, 0.0}}).x, 1e-12);
    }
  }
}

TEST(GamepadSteering, BeginsSmoothlyAtTheDeadZone) {
  EXPECT_LT(speed({.right = {0.2 + 1e-3, 0.0}}).x, 3.0 * 1e-5);
}

TEST(GamepadSteering, NothingIsFasterThanFullSpeed) {
  EXPECT_NEAR(glm::length(speed({.right = {1.0, 1.0}})), 3.0, 1e-12);
  EXPECT_NEAR(speed({.left = {1.0, 0.0}, .right = {1.0, 0.0}}).x, 3.0, 1e-12);
  StickResponse early = response;
  early.full_push = 0.9;
  EXPECT_NEAR(turn_speed({.right = {0.9, 0.0}}, early).right_rad_per_s, 3.0, 1e-12);
}

TEST(GamepadSteering, EitherStickTurns) {
  EXPECT_EQ(speed({.left = {0.6, 0.3}}), speed({.right = {0.6, 0.3}}));
  EXPECT_NEAR(speed({.left = {0.6, 0.0}, .right = {0.4, 0.0}}).x, 3.0 * (0.25 + 0.0625), 1e-12);
  EXPECT_EQ(speed({.left = {0.8, 0.0}, .right = {-0.8, 0.0}}).x, 0.0);
}

TEST(GamepadSteering, AxesThatAreNoNumbersAreAtRest) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(speed({.left = {nan, 0.0}, .right = {1.0, 0.0}}), speed({.right = {1.0, 0.0}}));
}

}  // namespace
}  // namespace foveola
