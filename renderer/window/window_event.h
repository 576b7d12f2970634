// Events of the window and their times: keys by the X server's stamps, others by the wake-up of the
// window's thread.
#pragma once

#include <mutex>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/head_tracker.h"

namespace foveola {

/// A key, by GLFW's number of its place on the keyboard; without repeats.
struct KeyMoved {
  int key = 0;
  bool is_down = false;
};
/// A typed character, by the keyboard's layout.
struct CharacterTyped {
  char32_t character = 0;
};
/// The pointer, in window coordinates from the top left corner; empty outside. The first event
/// gives its place when the window opens.
struct PointerMoved {
  bool is_inside = false;
  DVec2 position{0.0};
};
struct MouseButtonMoved {
  int button = 0;  ///< GLFW's number; 0 is the left button
  bool is_down = false;
};
/// The mouse's wheel, in its steps.
struct WheelTurned {
  double away = 0.0;  ///< away from the user; negative towards the user
};
/// The first gamepad's sticks; at rest without one.
struct GamepadMoved {
  GamepadSticks sticks;
};
struct WindowResized {
  IVec2 framebuffer{0};  ///< pixels
  IVec2 window{0};       ///< window coordinates
};
/// Minimised: nothing of it is visible.
struct WindowHidden {
  bool is_hidden = false;
};
/// Whether the window receives keys.
struct WindowFocused {
  bool has_focus = false;
};
struct MonitorLost {
  std::string name;
};
struct MonitorFound {
  std::string name;
};
struct CloseWanted {};

enum class HeadsetChange {
  recentred,   ///< straight ahead has changed
  lost_focus,  ///< it shows other content, or none: no display and no keys
  got_focus,
  taken_off,
  put_on,
  lost,        ///< the headset or its runtime is gone
  found,       ///< the headset is back
  exit_wanted  ///< its runtime asks the program to end
};
struct HeadsetChanged {
  HeadsetChange change = HeadsetChange::got_focus;
};

/// "the headset was taken off" and so on.
const char* words_for(HeadsetChange change);

struct WindowEvent {
  Nanoseconds time{0};
  std::variant<KeyMoved, CharacterTyped, PointerMoved, MouseButtonMoved, WheelTurned, GamepadMoved,
               WindowResized, WindowHidden, WindowFocused, MonitorLost, MonitorFound, CloseWanted,
               HeadsetChanged>
      what;
};

/// Passes events from the thread that waits for them to the one that handles them.
class WindowEvents {
 public:
  /// Also requests a stop by closing() if the user wants to leave: by Escape or the window's cross.
  void push(WindowEvent event);
  /// All events since the last call, in order.
  std::vector<WindowEvent> take();
  /// Stopped once the user wants to leave; for work that does not handle events, such as loading.
  std::stop_token closing() const { return closing_.get_token(); }

 private:
  std::stop_source closing_;
  std::mutex mutex_;
  std::vector<WindowEvent> events_;
};

}  // namespace foveola
