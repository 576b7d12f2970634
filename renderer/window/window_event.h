// What happens to the window, and when: keys by the X server's stamps, all else as the window's
// thread wakes for it.
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

/// A key, by GLFW's number of its place on the keyboard; repeats are left out.
struct KeyMoved {
  int key = 0;
  bool is_down = false;
};
/// What was typed, as the keyboard's layout has it.
struct CharacterTyped {
  char32_t character = 0;
};
/// The pointer, in window coordinates from the top left corner; empty once it has left. The first
/// one says where it is as the window opens.
struct PointerMoved {
  bool is_inside = false;
  DVec2 position{0.0};
};
struct MouseButtonMoved {
  int button = 0;  ///< GLFW's number; 0 is the left one
  bool is_down = false;
};
/// The mouse's wheel, in its steps.
struct WheelTurned {
  double away = 0.0;  ///< away from the user; negative towards him
};
/// The first gamepad's sticks; at rest once it is gone.
struct GamepadMoved {
  GamepadSticks sticks;
};
struct WindowResized {
  IVec2 framebuffer{0};  ///< pixels
  IVec2 window{0};       ///< window coordinates
};
/// Minimised: nothing of it can be seen.
struct WindowHidden {
  bool is_hidden = false;
};
/// Whether keys come to the window, or go to another.
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
  recentred,   ///< straight ahead is elsewhere from now on
  lost_focus,  ///< it shows something else, or nothing: nothing is seen or pressed
  got_focus,
  taken_off,
  put_on,
  lost,        ///< it, or its runtime, is gone
  found,       ///< it is back
  exit_wanted  ///< its runtime wants the program to end
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

/// Passes events from the thread that waits for them to the one that answers them.
class WindowEvents {
 public:
  /// Requests a stop by closing(), too, if the user wants to leave: by Escape or the window's
  /// cross.
  void push(WindowEvent event);
  /// All since the last call, in order.
  std::vector<WindowEvent> take();
  /// Stopped once the user wanted to leave; for what does not take events, such as loading.
  std::stop_token closing() const { return closing_.get_token(); }

 private:
  std::stop_source closing_;
  std::mutex mutex_;
  std::vector<WindowEvent> events_;
};

}  // namespace foveola
