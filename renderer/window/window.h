// A window of GLFW with an OpenGL 3.3 context and timestamped events.
//
// The program's first thread creates it, waits for its events and destroys it, as GLFW requires.
// Another may draw: it owns the context between make_current and release.
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
  std::optional<int> monitor;  ///< full screen on this monitor, by its number in monitors()
  /// The user's remedy for the loss of the display, which ends the program (see LostDisplay).
  std::string display_lost_remedy = "start it again where there is one";
};

/// The window's place on its monitor.
struct WindowPlace {
  IVec2 monitor_px{0};
  DVec2 centre_px{0.0};  ///< centre of the window, right of and below the monitor's centre
};

struct MonitorInfo {
  std::string name;
  IVec2 size_px{0};
  double width_m = 0.0;          ///< of the visible area, as the system reports it; 0 if unknown
  double refresh_rate_hz = 0.0;  ///< as the system reports it; 0 if unknown
};

class Window {
 public:
  /// events and clock must outlive it. Only one at a time. Throws Error if there is no display, no
  /// OpenGL 3.3, or no such monitor.
  Window(const WindowSettings& settings, WindowEvents& events, const Clock& clock);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // --- The thread that created it ---

  std::vector<MonitorInfo> monitors() const;
  IVec2 framebuffer_size() const;
  /// Waits for events and passes them on until finish() is called or `stop` is requested. Closing
  /// the window is reported as an event.
  void dispatch_events(const std::stop_token& stop);

  // --- Any thread ---

  /// Makes dispatch_events return.
  void finish();
  /// Switches between the window and full screen on its monitor, once events are passed on.
  void toggle_full_screen();
  /// The origin of its keys' times; constant.
  KeyTimeSource key_time_source() const { return key_times_->source(); }
  /// Whether it receives keys.
  bool has_focus() const { return has_focus_; }
  /// nullopt if it is on no monitor, or on one of several without filling it: the tracker's monitor
  /// is then unknown.
  std::optional<WindowPlace> place() const;

  // --- The drawing thread ---

  /// Makes the context current in this thread. swap() then waits for swap_interval refreshes of the
  /// display.
  void make_current(int swap_interval = 1);
  void release();
  /// Shows the drawn frame, at the next refresh if the display has refreshes.
  void swap();

 private:
  struct Callbacks;
  struct Library;

  void push(decltype(WindowEvent::what) what);
  void push(Nanoseconds time, decltype(WindowEvent::what) what);
  void follow_toggles();
  /// Reports the pointer's position, since a resting pointer has no events.
  void report_pointer();
  void poll_gamepad();
  void report_monitors();
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
  GamepadSticks sticks_;  ///< as last reported
  std::map<GLFWmonitor*, std::string> known_monitors_;
  mutable std::mutex mutex_;  ///< guards the place
  std::optional<WindowPlace> place_;
  std::atomic<bool> has_focus_ = false;
  std::atomic<bool> finished_ = false;
  std::atomic<int> toggles_ = 0;
};

}  // namespace foveola
