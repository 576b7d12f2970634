#include "renderer/window/mouse_drags.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/matchers.h"

namespace foveola {
namespace {

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

}  // namespace
}  // namespace foveola
