#include "renderer/window/window.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

/// Interval of polling events and the gamepad. GLFW has no events of gamepads. The drawing thread
/// shares the connection to the X server: while it waits for an answer there, it may read a key's
/// event, which then stays in the queue until the next event (up to 50 ms late in measurements).
/// While it has not read an arrived answer, GLFW's wait for events spins, on a core that traces.
constexpr std::chrono::milliseconds look_interval{1};

std::string glfw_fault() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description != nullptr ? description : "no reason given";
}

std::vector<GLFWmonitor*> glfw_monitors() {
  int count = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  return {monitors, monitors + count};
}

GLFWmonitor* monitor_of(int number) {
  const std::vector<GLFWmonitor*> monitors = glfw_monitors();
  if (number < 0 || number >= static_cast<int>(monitors.size())) {
    throw Error("window",
                fmt::format("there is no monitor {}, only {} of them", number, monitors.size()),
                "count from 0");
  }
  return monitors[static_cast<std::size_t>(number)];
}

/// All 0 for a monitor that is gone before GLFW has noticed.
GLFWvidmode mode_of(GLFWmonitor* monitor) {
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  return mode != nullptr ? *mode : GLFWvidmode{};
}

}  // namespace

/// GLFW itself, while there is a window.
struct Window::Library {
  Library() {
#if GLFW_VERSION_MAJOR > 3 || GLFW_VERSION_MINOR >= 4
    // Through Xwayland on Wayland desktops, as in GLFW 3.3: keys have their times from X.
    glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (glfwInit() != GLFW_TRUE) {
      throw Error("window", "there is no display to open one on: " + glfw_fault(),
                  "set DISPLAY, or run under xvfb-run");
    }
  }
  ~Library() { glfwTerminate(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

/// GLFW's callbacks, each of which finds its window.
struct Window::Callbacks {
  static Window& of(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
  }
  static void key(GLFWwindow* window, int key, int keycode, int action, int /*modifiers*/) {
    Window& self = of(window);
    const bool is_down = action != GLFW_RELEASE;
    // nullopt for a release that GLFW makes up when another window takes the keyboard.
    const std::optional<Nanoseconds> time = self.key_times_->take(keycode, is_down);
    if (action != GLFW_REPEAT) {
      self.push(time.value_or(self.clock_->now()), KeyMoved{.key = key, .is_down = is_down});
    }
  }
  static void character(GLFWwindow* window, unsigned int character) {
    of(window).push(CharacterTyped{.character = character});
  }
  static void pointer(GLFWwindow* window, double x, double y) {
    of(window).push(PointerMoved{.is_inside = true, .position = {x, y}});
  }
  static void pointer_entered(GLFWwindow* window, int entered) {
    if (entered == GLFW_FALSE) {
      of(window).push(PointerMoved{.is_inside = false});
    }
  }
  static void mouse_button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
    of(window).push(MouseButtonMoved{.button = button, .is_down = action == GLFW_PRESS});
  }
  static void wheel(GLFWwindow* window, double /*right*/, double away) {
    of(window).push(WheelTurned{.away = away});
  }
  static void moved(GLFWwindow* window, int /*x*/, int /*y*/) { of(window).find_place(); }
  static void resized(GLFWwindow* window, int width, int height) {
    of(window).find_place();
    WindowResized resized{.framebuffer = {width, height}};
    glfwGetWindowSize(window, &resized.window.x, &resized.window.y);
    of(window).push(resized);
    of(window).report_pointer();  // a resting pointer now has another place in it
  }
  static void hidden(GLFWwindow* window, int iconified) {
    of(window).push(WindowHidden{.is_hidden = iconified == GLFW_TRUE});
  }
  static void focused(GLFWwindow* window, int has_focus) {
    Window& self = of(window);
    self.has_focus_ = has_focus == GLFW_TRUE;
    self.push(WindowFocused{.has_focus = self.has_focus_});
    if (self.has_focus_) {
      self.report_pointer();
    }
  }
  static void close(GLFWwindow* window) {
    glfwSetWindowShouldClose(window, GLFW_FALSE);
    of(window).push(CloseWanted{});
  }
};

Window::Window(const WindowSettings& settings, WindowEvents& events, const Clock& clock)
    : library_(std::make_unique<Library>()),
      lost_display_(std::make_unique<LostDisplay>(settings.display_lost_remedy)),
      events_(&events),
      clock_(&clock),
      restored_size_(settings.size) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  // A participant's picture must not vanish because another monitor was clicked.
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
  GLFWmonitor* const monitor = settings.monitor ? monitor_of(*settings.monitor) : nullptr;
  IVec2 size = settings.size;
  if (monitor != nullptr) {
    const GLFWvidmode mode = mode_of(monitor);
    size = {mode.width, mode.height};
    glfwWindowHint(GLFW_REFRESH_RATE, mode.refreshRate);
  }
  window_ = glfwCreateWindow(size.x, size.y, settings.title.c_str(), monitor, nullptr);
  if (window_ == nullptr) {
    throw Error("window", "OpenGL 3.3 is not available: " + glfw_fault(),
                "update the graphics driver, or use Mesa's");
  }
  key_times_.emplace(window_, clock);
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, Callbacks::key);
  glfwSetCharCallback(window_, Callbacks::character);
  glfwSetCursorPosCallback(window_, Callbacks::pointer);
  glfwSetCursorEnterCallback(window_, Callbacks::pointer_entered);
  glfwSetMouseButtonCallback(window_, Callbacks::mouse_button);
  glfwSetScrollCallback(window_, Callbacks::wheel);
  glfwSetWindowPosCallback(window_, Callbacks::moved);
  glfwSetFramebufferSizeCallback(window_, Callbacks::resized);
  glfwSetWindowIconifyCallback(window_, Callbacks::hidden);
  glfwSetWindowFocusCallback(window_, Callbacks::focused);
  glfwSetWindowCloseCallback(window_, Callbacks::close);
  has_focus_ = glfwGetWindowAttrib(window_, GLFW_FOCUSED) == GLFW_TRUE;
  glfwGetWindowPos(window_, &restored_position_.x, &restored_position_.y);
  for (GLFWmonitor* const known : glfw_monitors()) {
    known_monitors_[known] = glfwGetMonitorName(known);
  }
  find_place();
  report_pointer();
}

Window::~Window() {
  key_times_.reset();
  glfwDestroyWindow(window_);
}

std::vector<MonitorInfo> Window::monitors() const {
  std::vector<MonitorInfo> list;
  for (GLFWmonitor* const monitor : glfw_monitors()) {
    const GLFWvidmode mode = mode_of(monitor);
    int width_mm = 0;
    glfwGetMonitorPhysicalSize(monitor, &width_mm, nullptr);
    list.push_back({.name = glfwGetMonitorName(monitor),
                    .size_px = {mode.width, mode.height},
                    .width_m = 1e-3 * width_mm,
                    .refresh_rate_hz = static_cast<double>(mode.refreshRate)});
  }
  return list;
}

IVec2 Window::framebuffer_size() const {
  IVec2 size(0);
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

void Window::dispatch_events(const std::stop_token& stop) {
  while (!finished_ && !stop.stop_requested()) {
    std::this_thread::sleep_for(look_interval);
    glfwPollEvents();
    poll_gamepad();
    report_monitors();
    follow_toggles();
  }
}

void Window::finish() { finished_ = true; }

void Window::toggle_full_screen() { ++toggles_; }

void Window::make_current(int swap_interval) {
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(swap_interval);
}

void Window::release() { glfwMakeContextCurrent(nullptr); }

void Window::swap() { glfwSwapBuffers(window_); }

void Window::push(decltype(WindowEvent::what) what) { push(clock_->now(), std::move(what)); }

void Window::push(Nanoseconds time, decltype(WindowEvent::what) what) {
  events_->push({.time = time, .what = std::move(what)});
}

void Window::report_pointer() {
  PointerMoved pointer{.is_inside = glfwGetWindowAttrib(window_, GLFW_HOVERED) == GLFW_TRUE};
  if (pointer.is_inside) {
    glfwGetCursorPos(window_, &pointer.position.x, &pointer.position.y);
  }
  push(pointer);
}

void Window::poll_gamepad() {
  GLFWgamepadstate state{};
  glfwGetGamepadState(GLFW_JOYSTICK_1, &state);  // leaves zeros if there is none
  const GamepadSticks sticks{
      .left = {state.axes[GLFW_GAMEPAD_AXIS_LEFT_X], state.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]},
      .right = {state.axes[GLFW_GAMEPAD_AXIS_RIGHT_X], state.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]}};
  if (sticks.left != sticks_.left || sticks.right != sticks_.right) {
    sticks_ = sticks;
    push(GamepadMoved{sticks});
  }
}

void Window::report_monitors() {
  // GLFW's own callback does not name the window. A window on a lost monitor leaves full screen by
  // itself.
  std::map<GLFWmonitor*, std::string> now;
  for (GLFWmonitor* const monitor : glfw_monitors()) {
    now[monitor] = glfwGetMonitorName(monitor);
  }
  for (const auto& [monitor, name] : known_monitors_) {
    if (!now.contains(monitor)) {
      push(MonitorLost{name});
    }
  }
  for (const auto& [monitor, name] : now) {
    if (!known_monitors_.contains(monitor)) {
      push(MonitorFound{name});
    }
  }
  if (now != known_monitors_) {
    known_monitors_ = std::move(now);
    stay_on_a_monitor();
    find_place();
  }
}

void Window::follow_toggles() {
  if (toggles_.exchange(0) % 2 == 0) {
    return;
  }
  if (glfwGetWindowMonitor(window_) != nullptr) {
    leave_full_screen();
  } else {
    GLFWmonitor* const below = monitor_below();
    enter_full_screen(below != nullptr ? below : glfwGetPrimaryMonitor());
  }
}

void Window::leave_full_screen() {
  glfwSetWindowMonitor(window_, nullptr, restored_position_.x, restored_position_.y,
                       restored_size_.x, restored_size_.y, GLFW_DONT_CARE);
}

void Window::enter_full_screen(GLFWmonitor* monitor) {
  if (monitor == nullptr) {
    return;
  }
  glfwGetWindowPos(window_, &restored_position_.x, &restored_position_.y);
  glfwGetWindowSize(window_, &restored_size_.x, &restored_size_.y);
  const GLFWvidmode mode = mode_of(monitor);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode.width, mode.height, mode.refreshRate);
}

GLFWmonitor* Window::monitor_below() const {
  IVec2 position(0);
  IVec2 size(0);
  glfwGetWindowPos(window_, &position.x, &position.y);
  glfwGetWindowSize(window_, &size.x, &size.y);
  const IVec2 middle = position + size / 2;
  for (GLFWmonitor* const monitor : glfw_monitors()) {
    IVec2 corner(0);
    glfwGetMonitorPos(monitor, &corner.x, &corner.y);
    const GLFWvidmode mode = mode_of(monitor);
    const IVec2 place = middle - corner;
    if (place.x >= 0 && place.y >= 0 && place.x < mode.width && place.y < mode.height) {
      return monitor;
    }
  }
  return nullptr;
}

std::optional<WindowPlace> Window::place() const {
  const std::lock_guard lock(mutex_);
  return place_;
}

void Window::find_place() {
  std::optional<WindowPlace> place;
  if (GLFWmonitor* const monitor = monitor_below(); monitor != nullptr) {
    IVec2 corner(0);
    IVec2 position(0);
    IVec2 size(0);
    glfwGetMonitorPos(monitor, &corner.x, &corner.y);
    glfwGetWindowPos(window_, &position.x, &position.y);
    glfwGetWindowSize(window_, &size.x, &size.y);
    const GLFWvidmode mode = mode_of(monitor);
    const IVec2 monitor_px(mode.width, mode.height);
    if (glfw_monitors().size() == 1 || (position == corner && size == monitor_px)) {
      place = WindowPlace{
          .monitor_px = monitor_px,
          .centre_px = DVec2(position - corner) + 0.5 * (DVec2(size) - DVec2(monitor_px))};
    }
  }
  const std::lock_guard lock(mutex_);
  place_ = place;
}

/// GLFW moves a window of a lost monitor to the desktop's corner, and only a window manager would
/// notice that there may be no monitor.
void Window::stay_on_a_monitor() {
  GLFWmonitor* const left = glfwGetPrimaryMonitor();
  if (left == nullptr || glfwGetWindowMonitor(window_) != nullptr || monitor_below() != nullptr) {
    return;
  }
  IVec2 corner(0);
  IVec2 size(0);
  glfwGetMonitorPos(left, &corner.x, &corner.y);
  glfwGetWindowSize(window_, &size.x, &size.y);
  const GLFWvidmode mode = mode_of(left);
  if (mode.width > 0) {
    glfwSetWindowSize(window_, std::min(size.x, mode.width), std::min(size.y, mode.height));
  }
  glfwSetWindowPos(window_, corner.x, corner.y);
}

}  // namespace foveola
