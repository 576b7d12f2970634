#include "renderer/window/window.h"

#include <algorithm>
#include <functional>
#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/waiting.h"
#include "tests/x_server.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

constexpr const char* title = "A window of the tests";

/// The server may read a clock that goes by ticks of this length.
constexpr milliseconds tick_of_server{1};

using IsLast = std::function<bool(const WindowEvent&)>;

/// The events that `act` gives rise to, until those that `is_last` is true of, however long that
/// takes; but not for ever.
std::vector<WindowEvent> pass_on_while(Window& window, WindowEvents& events,
                                       const std::function<void()>& act, const IsLast& is_last) {
  const SteadyClock clock;
  std::vector<WindowEvent> all;
  const std::stop_source done;
  const std::jthread user_thread([&, done]() mutable {
    act();
    const Nanoseconds end = clock.now() + test::patience;
    bool is_over = false;
    while (!is_over && clock.now() < end) {
      for (const WindowEvent& event : events.take()) {
        all.push_back(event);
        is_over = is_over || is_last(event);
      }
      std::this_thread::sleep_for(milliseconds(1));
    }
    done.request_stop();
  });
  window.dispatch_events(done.get_token());
  return all;
}

IsLast has_size(const IVec2& size) {
  return [size](const WindowEvent& event) {
    const auto* resized = std::get_if<WindowResized>(&event.what);
    return resized != nullptr && resized->framebuffer == size;
  };
}

/// A window whose events are passed on while a user does something.
class WindowTest : public ::testing::Test {
 protected:
  std::vector<WindowEvent> events_while(const std::function<void(test::XUser&)>& act,
                                        const IsLast& is_last) {
    test::XUser user(server_.display());
    return pass_on_while(window_, events_, [&] { act(user); }, is_last);
  }

  test::XServer server_;
  SteadyClock clock_;
  WindowEvents events_;
  Window window_{{.title = title, .size = {400, 300}}, events_, clock_};
};

TEST_F(WindowTest, HasTheSizeThatWasAskedFor) {
  EXPECT_EQ(window_.framebuffer_size(), IVec2(400, 300));
  const std::vector<MonitorInfo> monitors = window_.monitors();
  ASSERT_EQ(monitors.size(), 1U);
  EXPECT_EQ(monitors[0].size_px, IVec2(1280, 1024));
}

/// The newest that `events` hold; empty if there is none.
std::optional<PointerMoved> newest_pointer(const std::vector<WindowEvent>& events) {
  std::optional<PointerMoved> newest;
  for (const WindowEvent& event : events) {
    if (const auto* pointer = std::get_if<PointerMoved>(&event.what)) {
      newest = *pointer;
    }
  }
  return newest;
}

TEST(WindowOpeningTest, SaysWhereThePointerRests) {
  const test::XServer server;
  const SteadyClock clock;
  const WindowSettings settings{.title = title, .size = {400, 300}};
  WindowEvents events;
  {
    const Window window(settings, events, clock);
    const auto outside = newest_pointer(events.take());
    ASSERT_TRUE(outside);
    EXPECT_FALSE(outside->is_inside) << "it rests in the middle of the screen at first";
    test::XUser user(server.display());
    user.point_at(title, 123, 45);
    user.settle();
  }
  const Window window(settings, events, clock);
  const auto inside = newest_pointer(events.take());
  ASSERT_TRUE(inside);
  EXPECT_TRUE(inside->is_inside);
  EXPECT_EQ(inside->position, DVec2(123, 45));
}

TEST_F(WindowTest, SaysWhereThePointerRestsAfterItsSizeChanged) {
  const auto size_then_pointer = [is_resized = false](const WindowEvent& event) mutable {
    is_resized = is_resized || std::holds_alternative<WindowResized>(event.what);
    return is_resized && std::holds_alternative<PointerMoved>(event.what);
  };
  const auto events = events_while(
      [&](test::XUser& user) {
        user.point_at(title, 300, 200);
        user.settle();
        user.resize(title, 320, 240);
      },
      size_then_pointer);
  const auto pointer = newest_pointer(events);
  ASSERT_TRUE(pointer);
  EXPECT_TRUE(pointer->is_inside);
  EXPECT_EQ(pointer->position, DVec2(300, 200));
}

TEST_F(WindowTest, SaysWhetherKeysComeToIt) {
  const auto focused = [](bool has_focus) {
    return [has_focus](const WindowEvent& event) {
      const auto* focus = std::get_if<WindowFocused>(&event.what);
      return focus != nullptr && focus->has_focus == has_focus;
    };
  };
  EXPECT_TRUE(window_.has_focus());
  events_while([](test::XUser& user) { user.focus_elsewhere(); }, focused(false));
  EXPECT_FALSE(window_.has_focus());
  const auto events = events_while([](test::XUser& user) { user.focus(title); }, focused(true));
  EXPECT_TRUE(window_.has_focus());
  EXPECT_FALSE(std::any_of(events.begin(), events.end(), focused(false)));
}

TEST_F(WindowTest, KeysComeWithTheTimeAtWhichTheyMoved) {
  Nanoseconds before{0};
  Nanoseconds between{0};
  const auto events = events_while(
      [&](test::XUser& user) {
        user.point_at(title, 200, 150);
        before = clock_.now();
        user.hold("m");
        user.settle();  // the server has taken it
        between = clock_.now() + tick_of_server;
        std::this_thread::sleep_for(2 * tick_of_server);
        user.let_go("m");
      },
      [](const WindowEvent& event) {
        const auto* key = std::get_if<KeyMoved>(&event.what);
        return key != nullptr && !key->is_down;
      });
  std::vector<WindowEvent> keys;
  int characters = 0;
  for (const WindowEvent& event : events) {
    if (std::holds_alternative<KeyMoved>(event.what)) {
      keys.push_back(event);
    } else if (const auto* typed = std::get_if<CharacterTyped>(&event.what)) {
      EXPECT_EQ(typed->character, U'm');
      ++characters;
    }
  }
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(std::get<KeyMoved>(keys[0].what).key, GLFW_KEY_M);
  EXPECT_TRUE(std::get<KeyMoved>(keys[0].what).is_down);
  EXPECT_GE(keys[0].time, before - tick_of_server);
  EXPECT_LE(keys[0].time, between);
  EXPECT_GE(keys[1].time, between - tick_of_server);
  EXPECT_GE(characters, 1);
}

TEST_F(WindowTest, KeysHaveTheServersTimeHoweverLateTheyAreRead) {
  EXPECT_EQ(window_.key_time_source(), KeyTimeSource::server_stamp);
  std::vector<Nanoseconds> before;
  std::vector<Nanoseconds> after;
  test::XUser user(server_.display());
  user.point_at(title, 200, 150);
  for (const char* const key : {"m", "Tab", "m"}) {
    before.push_back(clock_.now());
    user.type(key);
    user.settle();
    after.push_back(clock_.now());
    std::this_thread::sleep_for(milliseconds(30));
  }
  std::vector<WindowEvent> downs;
  const auto is_last = [&](const WindowEvent& event) {
    const auto* key = std::get_if<KeyMoved>(&event.what);
    if (key != nullptr && key->is_down) {
      downs.push_back(event);
    }
    return downs.size() == before.size();
  };
  pass_on_while(window_, events_, [] {}, is_last);
  ASSERT_EQ(downs.size(), before.size());
  for (std::size_t i = 0; i < downs.size(); ++i) {
    EXPECT_GE(downs[i].time, before[i] - tick_of_server) << i;
    EXPECT_LE(downs[i].time, after[i] + milliseconds(1)) << i;
  }
}

TEST_F(WindowTest, ThePointerAndItsButtonCome) {
  const auto events = events_while(
      [](test::XUser& user) {
        user.point_at(title, 120, 80);
        user.press_button(1);
        user.release_button(1);
      },
      [](const WindowEvent& event) {
        const auto* button = std::get_if<MouseButtonMoved>(&event.what);
        return button != nullptr && !button->is_down;
      });
  std::optional<DVec2> place;
  int presses = 0;
  for (const WindowEvent& event : events) {
    if (const auto* pointer = std::get_if<PointerMoved>(&event.what);
        pointer && pointer->is_inside) {
      place = pointer->position;
    } else if (const auto* button = std::get_if<MouseButtonMoved>(&event.what)) {
      EXPECT_EQ(button->button, GLFW_MOUSE_BUTTON_LEFT);
      presses += button->is_down ? 1 : 0;
    }
  }
  ASSERT_TRUE(place);
  EXPECT_EQ(*place, DVec2(120, 80));
  EXPECT_EQ(presses, 1);
}

TEST_F(WindowTest, SaysWhereItIsOnTheOnlyMonitor) {
  test::XUser user(server_.display());
  const auto expect_place = [&] {
    const test::XUser::Place at = user.place_of(title);
    const auto place = window_.place();
    ASSERT_TRUE(place);
    EXPECT_EQ(place->monitor_px, IVec2(1280, 1024));
    EXPECT_EQ(place->centre_px,
              DVec2(at.x + at.width / 2.0 - 640.0, at.y + at.height / 2.0 - 512.0));
  };
  expect_place();
  events_while([](test::XUser& hands) { hands.resize(title, 640, 200); }, has_size({640, 200}));
  expect_place();
}

TEST_F(WindowTest, AWishToCloseIsAnEvent) {
  const auto is_wish = [](const WindowEvent& event) {
    return std::holds_alternative<CloseWanted>(event.what);
  };
  const auto events = events_while([](test::XUser& user) { user.ask_to_close(title); }, is_wish);
  EXPECT_TRUE(std::any_of(events.begin(), events.end(), is_wish));
}

TEST_F(WindowTest, ItSaysWhenItIsMinimised) {
  const auto hidden = [](bool is_hidden) {
    return [is_hidden](const WindowEvent& event) {
      const auto* what = std::get_if<WindowHidden>(&event.what);
      return what != nullptr && what->is_hidden == is_hidden;
    };
  };
  const auto away =
      events_while([](test::XUser& user) { user.say_minimised(title, true); }, hidden(true));
  EXPECT_TRUE(std::any_of(away.begin(), away.end(), hidden(true)));
}

/// Whether it reports that a monitor was lost or found.
template <typename What>
IsLast tells_of(const std::string& monitor) {
  return [monitor](const WindowEvent& event) {
    const auto* what = std::get_if<What>(&event.what);
    return what != nullptr && what->name == monitor;
  };
}

class MonitorTest : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      monitors_.emplace();
    } catch (const std::runtime_error& reason) {
      GTEST_SKIP() << reason.what();
    }
  }

  std::optional<test::XMonitors> monitors_;
  SteadyClock clock_;
  WindowEvents events_;
};

TEST_F(MonitorTest, AreListedWithTheirRefreshRates) {
  const Window window({}, events_, clock_);
  const std::vector<MonitorInfo> monitors = window.monitors();
  ASSERT_EQ(monitors.size(), 2U);
  EXPECT_EQ(monitors[0].name, "DUMMY0");
  EXPECT_EQ(monitors[0].size_px, IVec2(1024, 768));
  EXPECT_EQ(monitors[0].refresh_rate_hz, 60.0);
  EXPECT_EQ(monitors[1].name, "DUMMY1");
  EXPECT_EQ(monitors[1].size_px, IVec2(800, 600));
  EXPECT_EQ(monitors[1].refresh_rate_hz, 56.0) << "GLFW rounds 56.25";
}

TEST_F(MonitorTest, AWindowLeavesFullScreenWithItsMonitor) {
  Window window({.monitor = 1}, events_, clock_);
  EXPECT_EQ(window.framebuffer_size(), IVec2(800, 600));
  const auto is_lost = tells_of<MonitorLost>("DUMMY1");
  const auto lost =
      pass_on_while(window, events_, [&] { monitors_->take_away("DUMMY1"); }, is_lost);
  EXPECT_TRUE(std::any_of(lost.begin(), lost.end(), is_lost));
  EXPECT_EQ(window.monitors().size(), 1U);

  // It is a window like others now: it can fill the monitor that is left.
  const auto fills_the_other = has_size({1024, 768});
  const auto filled =
      pass_on_while(window, events_, [&] { window.toggle_full_screen(); }, fills_the_other);
  EXPECT_TRUE(std::any_of(filled.begin(), filled.end(), fills_the_other));

  const auto is_found = tells_of<MonitorFound>("DUMMY1");
  const auto found =
      pass_on_while(window, events_, [&] { monitors_->bring_back("DUMMY1"); }, is_found);
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), is_found));
  EXPECT_EQ(window.monitors().size(), 2U);
  EXPECT_EQ(window.framebuffer_size(), IVec2(1024, 768)) << "it stays where it is";
}

TEST_F(MonitorTest, AWindowComesToAMonitorThatIsLeft) {
  Window window({.title = title, .monitor = 0}, events_, clock_);
  const auto is_lost = tells_of<MonitorLost>("DUMMY0");
  pass_on_while(window, events_, [&] { monitors_->take_away("DUMMY0"); }, is_lost);
  test::XUser user(monitors_->display());
  test::wait_until("the window on DUMMY1, whose left edge is at 1024", [&] {
    const auto place = user.place_of(title);
    return place.x == 1024 && place.y == 0 && place.width <= 800 && place.height <= 600;
  });
}

TEST_F(MonitorTest, AWindowStaysWhenAnotherMonitorIsLost) {
  Window window({.monitor = 0}, events_, clock_);
  const auto is_lost = tells_of<MonitorLost>("DUMMY1");
  const auto lost =
      pass_on_while(window, events_, [&] { monitors_->take_away("DUMMY1"); }, is_lost);
  EXPECT_TRUE(std::any_of(lost.begin(), lost.end(), is_lost));
  EXPECT_EQ(window.framebuffer_size(), IVec2(1024, 768));
}

TEST(WindowErrors, NoDisplayAndNoMonitorAreSaid) {
  const test::XServer server;
  WindowEvents events;
  const SteadyClock clock;
  const auto error_of_window = [&](const WindowSettings& settings) {
    return test::error_of([&] { const Window window(settings, events, clock); });
  };
  EXPECT_THAT(error_of_window({.monitor = 3}), HasSubstr("no monitor 3, only 1"));
  ::setenv("DISPLAY", ":9999", 1);
  EXPECT_THAT(error_of_window({}), HasSubstr("there is no display"));
}

}  // namespace
}  // namespace foveola
