// A window with an OpenGL 3.3 context: GLFW's, whose events arrive with their time.
//
// One thread, the program's first, makes it, waits for its events and destroys it, as GLFW asks.
// Another one may draw: between make_current and release the context is that thread's.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/window/key_times.h"
#include "renderer/window/window_event.h"
#include "renderer/window/x_display.h"

struct GLFWwindow;
struct GLFWmonitor;

namespace foveola {

struct WindowSettings {
  std::string title = "Foveola";
  IVec2 size{1280, 720};       ///< window coordinates; not used in full screen
  std::optional<int> monitor;  ///< full screen on this one, as monitors() numbers them
  /// What a user can do if the display goes away, which ends the program (see LostDisplay).
  std::string remedy_of_lost_display = "start it again where there is one";
};

/// Where the window is on the monitor that it shows on.
struct WindowPlace {
  IVec2 monitor_px{0};
  DVec2 middle_px{0.0};  ///< of the window, right of and below the monitor's middle
};

struct MonitorInfo {
  std::string name;
  IVec2 size_px{0};
  double width_m = 0.0;          ///< of its picture, as the system says; 0 if it does not
  double refresh_rate_hz = 0.0;  ///< as the system says; 0 if it does not
};

class Window {
 public:
  /// events and clock must outlive it. There can be one at a time. Throws Error if there is no
  /// display, no OpenGL 3.3, or no such monitor.
  Window(const WindowSettings& settings, WindowEvents& events, const Clock& clock);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // --- The thread that made it ---

  std::vector<MonitorInfo> monitors() const;
  IVec2 framebuffer_size() const;
  /// Waits for events and passes them on until finish() was called or `stop` is requested. A wish
  /// to close is an event like others.
  void pass_on_events(const std::stop_token& stop);

  // --- Any thread ---

  /// Lets pass_on_events return.
  void finish();
  /// Switches between the window and full screen on the monitor that it is on, as soon as events
  /// are passed on.
  void toggle_full_screen();
  /// What the times of its keys are; it does not change.
  KeyTimeSource key_time_source() const { return key_times_->source(); }
  /// Whether keys come to it.
  bool has_focus() const { return has_focus_; }
  /// Empty if it is on no monitor, or on one of several without filling it: then nobody knows which
  /// one an eye tracker watches.
  std::optional<WindowPlace> place() const;

  // --- The thread that draws ---

  /// With swaps that wait for so many of the display's refreshes.
  void make_current(int swap_interval = 1);
  void release();
  /// Shows what was drawn; with a display that has refreshes, at the next one.
  void swap();

 private:
  struct Callbacks;
  struct Library;

  void push(decltype(WindowEvent::what) what);
  void push(Nanoseconds time, decltype(WindowEvent::what) what);
  void follow_toggles();
  /// Where the pointer already is: it may rest where it is for long.
  void tell_of_pointer();
  void poll_gamepad();
  void tell_of_monitors();
  void leave_full_screen();
  void enter_full_screen(GLFWmonitor* monitor);
  GLFWmonitor* monitor_below() const;
  void find_place();
  void stay_on_a_monitor();

  std::unique_ptr<Library> library_;
  std::unique_ptr<LostDisplay> lost_display_;
  WindowEvents* events_;
  const Clock* clock_;
  GLFWwindow* window_ = nullptr;
  std::optional<KeyTimes> key_times_;
  IVec2 restored_position_{0};
  IVec2 restored_size_;
  GamepadSticks sticks_;  ///< as they were last reported
  std::map<GLFWmonitor*, std::string> known_monitors_;
  mutable std::mutex mutex_;  ///< guards the place
  std::optional<WindowPlace> place_;
  std::atomic<bool> has_focus_ = false;
  std::atomic<bool> finished_ = false;
  std::atomic<int> toggles_ = 0;
};

}  // namespace foveola
