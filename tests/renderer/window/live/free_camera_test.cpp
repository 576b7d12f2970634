#include "renderer/window/live/free_camera.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "renderer/view/viewport.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

/// A window of 1000x500 pixels that shows 90 degrees across, in a scene whose diagonal is 10 m: one
/// walks it at 1 m/s. All that is seen is a wall 4 m ahead of the origin, towards -Z.
class FreeCameraTest : public ::testing::Test {
 protected:
  FreeCameraTest() { camera_.show(geometry_, {1000, 500}, 1.0); }

  bool at(int time_ms, decltype(WindowEvent::what) what) {
    return camera_.follow({.time = milliseconds(time_ms), .what = std::move(what)});
  }
  bool press(int time_ms, int key) { return at(time_ms, KeyMoved{.key = key, .is_down = true}); }
  bool release(int time_ms, int key) { return at(time_ms, KeyMoved{.key = key, .is_down = false}); }
  void button(int time_ms, int button, bool is_down) {
    at(time_ms, MouseButtonMoved{.button = button, .is_down = is_down});
  }
  void point(int time_ms, double x, double y) {
    at(time_ms, PointerMoved{.is_inside = true, .position = {x, y}});
  }
  Vec3 position(int time_ms) {
    camera_.walk_until(milliseconds(time_ms));
    return camera_.position();
  }
  AzimuthElevation heading(int time_ms) { return head_.pose(milliseconds(time_ms)).heading; }
  void expect_near(const Vec3& actual, const Vec3& expected) {
    EXPECT_NEAR(glm::length(actual - expected), 0.0, 1e-4)
        << actual.x << ", " << actual.y << ", " << actual.z;
  }

  static std::optional<Sighted> wall(const Vec3& from, const Vec3& direction) {
    if (direction.z >= 0.0F) {
      return std::nullopt;
    }
    const float distance_m = (-4.0F - from.z) / direction.z;
    return Sighted{.object = "Wall",
                   .material = "Plaster",
                   .position = from + distance_m * direction,
                   .distance_m = distance_m,
                   .bounds = {.lower = {-1.0F, -1.0F, -4.0F}, .upper = {1.0F, 1.0F, -4.0F}}};
  }

  ViewGeometry geometry_{.horizontal_fov_deg = 90.0,
                         .vertical_fov_deg = 53.13,
                         .parts = {{.origin = IVec2(0), .size = {1000, 500}}}};
  SteeredHeadTracker head_{AzimuthElevation{}};
  FreeCamera camera_{{.bounds = {.lower = Vec3(0.0F), .upper = Vec3(6.0F, 0.0F, 8.0F)},
                      .origin = {100.0, 0.0, 0.0},
                      .look = wall},
                     head_};
};

TEST_F(FreeCameraTest, ShiftMakesArrowsMove) {
  EXPECT_FALSE(press(0, GLFW_KEY_UP)) << "arrows alone turn the head";
  release(0, GLFW_KEY_UP);
  press(0, GLFW_KEY_LEFT_SHIFT);
  EXPECT_TRUE(press(1000, GLFW_KEY_UP));
  EXPECT_TRUE(camera_.is_moving());
  expect_near(position(1500), {0.0F, 0.0F, -0.5F});
  release(3000, GLFW_KEY_UP);
  EXPECT_FALSE(camera_.is_moving());
  expect_near(position(9000), {0.0F, 0.0F, -2.0F});
  EXPECT_EQ(camera_.place(), DVec3(100.0, 0.0, -2.0)) << "in the file's coordinates";
}

TEST_F(FreeCameraTest, MovesAsTheHeadLooksAndUpIsUp) {
  head_.turn(milliseconds(0), {.right_rad = radians(90.0), .up_rad = radians(-90.0)});
  press(0, GLFW_KEY_PAGE_UP);
  release(1000, GLFW_KEY_PAGE_UP);
  expect_near(position(1000), {0.0F, 1.0F, 0.0F});
  press(1000, GLFW_KEY_RIGHT_SHIFT);
  press(1000, GLFW_KEY_UP);
  expect_near(position(2000), {0.0F, 0.0F, 0.0F});
}

TEST_F(FreeCameraTest, LettersFlyWhileTheRightButtonIsHeld) {
  EXPECT_FALSE(press(0, GLFW_KEY_W));
  EXPECT_FALSE(at(0, CharacterTyped{'d'}));
  button(0, GLFW_MOUSE_BUTTON_RIGHT, true);
  EXPECT_TRUE(press(0, GLFW_KEY_D));
  EXPECT_TRUE(at(0, CharacterTyped{'d'})) << "it must not show densities";
  expect_near(position(1000), {1.0F, 0.0F, 0.0F});
  point(1000, 500, 250);
  point(1000, 400, 250);
  EXPECT_NEAR(degrees(heading(1000).azimuth_rad), 9.0, 1e-9);
  button(1000, GLFW_MOUSE_BUTTON_RIGHT, false);
  expect_near(position(2000), {1.0F, 0.0F, 0.0F});
}

TEST_F(FreeCameraTest, TheWheelChangesTheSpeedWithControl) {
  EXPECT_FALSE(at(0, WheelTurned{.away = 1.0})) << "alone it changes the field of view";
  press(0, GLFW_KEY_LEFT_CONTROL);
  EXPECT_TRUE(at(0, WheelTurned{.away = 1.0}));
  EXPECT_NEAR(camera_.speed_m_per_s(), 1.25, 1e-9);
  EXPECT_THAT(camera_.take_note(), HasSubstr("1.25 m/s"));
  EXPECT_EQ(camera_.take_note(), "");
  at(0, WheelTurned{.away = 1e4});
  EXPECT_EQ(camera_.speed_m_per_s(), 1000.0);
  at(0, WheelTurned{.away = -1e4});
  EXPECT_EQ(camera_.speed_m_per_s(), 0.001);
}

TEST_F(FreeCameraTest, ARoomIsWalkedThroughAsARoomWhateverLiesOutside) {
  const auto walls_all_around = [](const Vec3&, const Vec3&) {
    return std::optional(Sighted{.distance_m = 2.0});
  };
  const FreeCamera camera(
      {.bounds = {.lower = Vec3(-500.0F), .upper = Vec3(500.0F)}, .look = walls_all_around}, head_);
  EXPECT_NEAR(camera.speed_m_per_s(), 0.4, 1e-9);
}

TEST_F(FreeCameraTest, AClickLooksThereAndSaysWhatItIs) {
  point(0, 1000, 250);
  button(1, GLFW_MOUSE_BUTTON_LEFT, true);
  button(2, GLFW_MOUSE_BUTTON_LEFT, false);
  EXPECT_NEAR(degrees(heading(3).azimuth_rad), 45.0, 1e-4);
  EXPECT_EQ(camera_.take_note(), "'Wall' of 'Plaster', 5.66 m away");
  expect_near(position(3), Vec3(0.0F));
}

TEST_F(FreeCameraTest, NothingIsPickedWhereNothingIs) {
  head_.turn(milliseconds(0), {.right_rad = radians(180.0)});
  point(0, 500, 250);
  button(1, GLFW_MOUSE_BUTTON_LEFT, true);
  button(2, GLFW_MOUSE_BUTTON_LEFT, false);
  EXPECT_EQ(camera_.take_note(), "nothing is there");
  EXPECT_NEAR(std::abs(degrees(heading(3).azimuth_rad)), 180.0, 1e-4);
}

TEST_F(FreeCameraTest, OrbitsAroundWhatIsAhead) {
  point(0, 500, 250);
  button(1, GLFW_MOUSE_BUTTON_MIDDLE, true);
  point(2, 1000, 250);
  button(3, GLFW_MOUSE_BUTTON_MIDDLE, false);
  EXPECT_NEAR(degrees(heading(4).azimuth_rad), 90.0, 1e-4);
  expect_near(position(4), {-4.0F, 0.0F, -4.0F});
}

TEST_F(FreeCameraTest, AltMakesTheLeftButtonOrbitAndTurnNothingElse) {
  press(0, GLFW_KEY_LEFT_ALT);
  EXPECT_TRUE(at(1, MouseButtonMoved{.button = GLFW_MOUSE_BUTTON_LEFT, .is_down = true}));
  EXPECT_TRUE(at(2, MouseButtonMoved{.button = GLFW_MOUSE_BUTTON_LEFT, .is_down = false}));
  release(3, GLFW_KEY_LEFT_ALT);
  EXPECT_FALSE(at(4, MouseButtonMoved{.button = GLFW_MOUSE_BUTTON_LEFT, .is_down = true}));
}

TEST_F(FreeCameraTest, FitsWhatWasPickedOrAll) {
  camera_.fit(milliseconds(0));
  EXPECT_THAT(camera_.take_note(), HasSubstr("all fits"));
  // The near side's 6 m are nine tenths of the view's width: as wide as they are far away.
  expect_near(position(0), {3.0F, 0.0F, 8.0F + 3.0F / 0.9F});
  camera_.go_back(milliseconds(0));
  expect_near(position(0), Vec3(0.0F));
  point(0, 500, 250);
  button(1, GLFW_MOUSE_BUTTON_LEFT, true);
  button(2, GLFW_MOUSE_BUTTON_LEFT, false);
  camera_.take_note();
  camera_.fit(milliseconds(3));
  EXPECT_THAT(camera_.take_note(), HasSubstr("'Wall' fits"));
  // The view is half as high as wide, and the wall's 2 m are nine tenths of that.
  expect_near(position(3), {0.0F, 0.0F, -4.0F + 1.0F / 0.45F});
}

TEST_F(FreeCameraTest, AnEmptySceneHasNothingToFitOrPick) {
  FreeCamera camera({.look = [](const Vec3&, const Vec3&) { return std::optional<Sighted>(); }},
                    head_);
  camera.show(geometry_, {1000, 500}, 1.0);
  camera.fit(milliseconds(0));
  EXPECT_THAT(camera.take_note(), HasSubstr("nothing to fit"));
  EXPECT_EQ(camera.speed_m_per_s(), 1.0);
  EXPECT_EQ(camera.position(), Vec3(0.0F));
}

/// A recorded head looks to the right.
class ReplayedHeadTest : public FreeCameraTest {
 protected:
  ReplayedHeadTest() { replayed_.show(geometry_, {1000, 500}, 1.0); }

  bool at(decltype(WindowEvent::what) what) {
    return replayed_.follow({.time = milliseconds(0), .what = std::move(what)});
  }

  ScriptedHeadTracker recorded_{{{.heading = {.azimuth_rad = radians(90.0)}}}};
  FreeCamera replayed_{{.bounds = {.lower = Vec3(0.0F), .upper = Vec3(6.0F, 0.0F, 8.0F)},
                        .look =
                            [](const Vec3& from, const Vec3& direction) {
                              return wall(from, {direction.z, direction.y, -direction.x});
                            }},
                       recorded_,
                       "a recording"};
};

TEST_F(ReplayedHeadTest, WalksAndPicksAsItLooks) {
  at(KeyMoved{.key = GLFW_KEY_LEFT_SHIFT, .is_down = true});
  EXPECT_TRUE(at(KeyMoved{.key = GLFW_KEY_UP, .is_down = true}));
  replayed_.walk_until(milliseconds(1000));
  expect_near(replayed_.position(), {1.0F, 0.0F, 0.0F});
  at(PointerMoved{.is_inside = true, .position = {500, 250}});
  at(MouseButtonMoved{.button = GLFW_MOUSE_BUTTON_LEFT, .is_down = true});
  at(MouseButtonMoved{.button = GLFW_MOUSE_BUTTON_LEFT, .is_down = false});
  EXPECT_THAT(replayed_.take_note(), HasSubstr("'Wall'"));
}

TEST_F(FreeCameraTest, PicksAsATiltedHeadSees) {
  ScriptedHeadTracker tilted(std::vector{HeadPose{.roll_rad = radians(90.0)}});
  Vec3 looked_along(0.0F);
  FreeCamera camera({.look =
                         [&](const Vec3& /*from*/, const Vec3& direction) {
                           looked_along = direction;
                           return std::optional<Sighted>();
                         }},
                    tilted, "a headset");
  camera.show(geometry_, {1000, 500}, 1.0);
  const auto follow = [&](decltype(WindowEvent::what) what) {
    camera.follow({.time = milliseconds(0), .what = std::move(what)});
  };
  follow(PointerMoved{.is_inside = true, .position = {500.0, 0.0}});
  follow(MouseButtonMoved{.button = GLFW_MOUSE_BUTTON_LEFT, .is_down = true});
  follow(MouseButtonMoved{.button = GLFW_MOUSE_BUTTON_LEFT, .is_down = false});
  EXPECT_NEAR(degrees(azimuth_elevation(looked_along).azimuth_rad), 0.5 * 53.13, 0.01)
      << "the top of what is seen lies to the right";
  EXPECT_NEAR(looked_along.y, 0.0F, 1e-5F);
}

TEST_F(ReplayedHeadTest, IsNotTurnedAndSaysSo) {
  const auto expect_told = [&](const char* how) {
    EXPECT_THAT(replayed_.take_note(), HasSubstr("a recording turns the head")) << how;
  };
  EXPECT_TRUE(at(KeyMoved{.key = GLFW_KEY_LEFT, .is_down = true}));
  expect_told("arrow");
  at(KeyMoved{.key = GLFW_KEY_LEFT, .is_down = false});
  at(GamepadMoved{.sticks = {.right = {1.0, 0.0}}});
  expect_told("gamepad");
  at(GamepadMoved{});
  EXPECT_EQ(replayed_.take_note(), "");
  at(PointerMoved{.is_inside = true, .position = {500, 250}});
  for (const int button :
       {GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_MIDDLE, GLFW_MOUSE_BUTTON_RIGHT}) {
    at(MouseButtonMoved{.button = button, .is_down = true});
    at(PointerMoved{.is_inside = true, .position = {600, 250}});
    expect_told("drag");
    EXPECT_FALSE(replayed_.is_moving());
    at(PointerMoved{.is_inside = true, .position = {500, 250}});
    at(MouseButtonMoved{.button = button, .is_down = false});
    replayed_.take_note();
  }
  replayed_.go_back(milliseconds(0));
  replayed_.bring(milliseconds(0), Vec3(1.0F, 0.0F, 0.0F), Vec3(0.0F, 0.0F, -1.0F));
  expect_near(replayed_.position(), Vec3(0.0F));
  EXPECT_EQ(replayed_.take_note(), "");
}

TEST_F(FreeCameraTest, BringsWhatIsSeenElsewhere) {
  const Vec3 right = direction_below(geometry_, {1000.0, 250.0}, 500);
  camera_.bring(milliseconds(0), right, Vec3(0.0F, 0.0F, -1.0F));
  EXPECT_NEAR(degrees(heading(0).azimuth_rad), 45.0, 1e-4);
}

PointerMoved to(double x, double y) { return {.is_inside = true, .position = {x, y}}; }
MouseButtonMoved down(int button) { return {.button = button, .is_down = true}; }
MouseButtonMoved up(int button) { return {.button = button, .is_down = false}; }

TEST(MouseDragsTest, ButtonsMeanWhatTheyDo) {
  for (const auto& [button, alt, drag] : {std::tuple(GLFW_MOUSE_BUTTON_LEFT, false, Drag::turn),
                                          std::tuple(GLFW_MOUSE_BUTTON_LEFT, true, Drag::orbit),
                                          std::tuple(GLFW_MOUSE_BUTTON_MIDDLE, false, Drag::orbit),
                                          std::tuple(GLFW_MOUSE_BUTTON_RIGHT, false, Drag::fly),
                                          std::tuple(GLFW_MOUSE_BUTTON_4, false, Drag::none)}) {
    MouseDrags mouse;
    mouse.follow(down(button), alt);
    EXPECT_EQ(mouse.drag(), drag) << button;
    mouse.follow(up(button), alt);
    EXPECT_EQ(mouse.drag(), Drag::none) << button;
  }
}

TEST(MouseDragsTest, WaysAreInPixelsAndOnlyOfDrags) {
  MouseDrags mouse;
  mouse.show(2.0);
  EXPECT_EQ(mouse.follow(to(10, 10)), DVec2(0.0));
  EXPECT_EQ(mouse.follow(to(20, 10)), DVec2(0.0));
  mouse.follow(down(GLFW_MOUSE_BUTTON_RIGHT), false);
  EXPECT_EQ(mouse.follow(to(25, 7)), DVec2(10.0, -6.0));
  mouse.follow(PointerMoved{.is_inside = false});
  EXPECT_EQ(mouse.follow(to(100, 100)), DVec2(0.0)) << "where it came back is no way";
}

TEST(MouseDragsTest, WhatHardlyMovesIsAClick) {
  MouseDrags mouse;
  mouse.follow(to(40, 30));
  EXPECT_EQ(mouse.follow(down(GLFW_MOUSE_BUTTON_LEFT), false), std::nullopt);
  mouse.follow(to(41, 31));
  EXPECT_THAT(mouse.follow(up(GLFW_MOUSE_BUTTON_LEFT), false), Optional(DVec2(41, 31)));

  mouse.follow(down(GLFW_MOUSE_BUTTON_LEFT), false);
  mouse.follow(to(50, 31));
  mouse.follow(to(41, 31));
  EXPECT_EQ(mouse.follow(up(GLFW_MOUSE_BUTTON_LEFT), false), std::nullopt) << "a drag and back";

  mouse.follow(down(GLFW_MOUSE_BUTTON_LEFT), true);
  EXPECT_EQ(mouse.follow(up(GLFW_MOUSE_BUTTON_LEFT), true), std::nullopt) << "of an orbit";
}

TEST(MouseDragsTest, TheFirstButtonRules) {
  MouseDrags mouse;
  mouse.follow(down(GLFW_MOUSE_BUTTON_RIGHT), false);
  mouse.follow(down(GLFW_MOUSE_BUTTON_LEFT), false);
  mouse.follow(up(GLFW_MOUSE_BUTTON_LEFT), false);
  EXPECT_EQ(mouse.drag(), Drag::fly);
}

/// Where a point lies in the axes of a camera's head.
Vec3 in_head(const Standing& camera, const Vec3& point) {
  return glm::conjugate(head_orientation(camera.heading)) * (point - camera.position);
}

TEST(CameraMovesTest, AnOrbitKeepsItsPivotInPlace) {
  const Standing before{.position = {1.0F, 2.0F, 5.0F}, .heading = {radians(10.0), radians(-5.0)}};
  const Vec3 pivot(0.5F, 1.0F, -1.0F);
  const Standing after =
      orbited(before, pivot, {.right_rad = radians(70.0), .up_rad = radians(-30.0)});
  EXPECT_NEAR(degrees(after.heading.azimuth_rad), 80.0, 1e-9);
  EXPECT_NEAR(degrees(after.heading.elevation_rad), -35.0, 1e-9);
  EXPECT_NEAR(glm::length(in_head(after, pivot) - in_head(before, pivot)), 0.0, 1e-5);
  EXPECT_GT(glm::length(after.position - before.position), 1.0F);
}

TEST(CameraMovesTest, AQuarterRoundWhatIsAhead) {
  const Standing after =
      orbited({.position = {0.0F, 0.0F, 2.0F}}, Vec3(0.0F), {.right_rad = radians(90.0)});
  // Looking towards +X from the left of it.
  EXPECT_NEAR(glm::length(after.position - Vec3(-2.0F, 0.0F, 0.0F)), 0.0, 1e-6);
}

TEST(CameraMovesTest, AnOrbitStopsOverhead) {
  const Standing after =
      orbited({.position = {0.0F, 0.0F, 2.0F}}, Vec3(0.0F), {.up_rad = radians(-200.0)});
  EXPECT_NEAR(degrees(after.heading.elevation_rad), -90.0, 1e-9);
  EXPECT_NEAR(glm::length(after.position - Vec3(0.0F, 2.0F, 0.0F)), 0.0, 1e-5);
}

TEST(CameraMovesTest, SpeedFitsTheSpace) {
  EXPECT_NEAR(walking_speed(5.0), 0.5, 1e-9);
  EXPECT_EQ(walking_speed(0.0), 1.0);
}

}  // namespace

}  // namespace foveola
