// What is read of a real server's devices and keyboard.
#include "renderer/window/x_display.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/x_server.h"

namespace foveola {
namespace {

TEST(DesktopFacts, NameTheLayoutThatSetxkbmapSets) {
  const test::XServer server;
  EXPECT_EQ(desktop_facts().keyboard_layout, "us");
  ASSERT_EQ(std::system("setxkbmap -layout de,ru -variant nodeadkeys,"), 0);
  EXPECT_EQ(desktop_facts().keyboard_layout, "de(nodeadkeys),ru");
}

/// By the name that xwayland-input.c gives a seat's pointer, from 1.16 to 24.1: "%s:%d" of
/// "xwayland-pointer" and the seat's id.
TEST(DesktopFacts, KnowXwaylandByItsDevices) {
  const test::XServer server;
  EXPECT_EQ(desktop_facts().windows, "X11");
  test::XUser user(server.display());
  user.plug_in_pointer("xwayland-pointer:13");
  EXPECT_EQ(desktop_facts().windows, "XWayland");
}

}  // namespace
}  // namespace foveola
