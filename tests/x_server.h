// A display without a screen, and hands to type and point on it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <sys/types.h>

#include "tests/temporary_folder.h"

namespace foveola::test {

/// Xvfb with one monitor of 1280x1024, for as long as it lives. This process's DISPLAY names it,
/// and Mesa draws with the processor.
class XServer {
 public:
  /// Throws std::runtime_error, with what the server said, if there is no Xvfb.
  XServer();
  /// Another server, by its program and arguments. Throws std::runtime_error, with what it said, if
  /// it does not start.
  explicit XServer(std::vector<std::string> command);
  ~XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  const std::string& display() const { return display_; }
  /// Ends it as a crash does. Nothing of this process may be connected with it any more.
  void kill();

 private:
  void end(int signal);

  std::string display_;
  pid_t process_ = -1;
};

/// Xorg with two monitors side by side that can be taken away and brought back: "DUMMY0" of
/// 1024x768 pixels at 60 Hz, and to its right "DUMMY1" of 800x600 at 56.25 Hz.
class XMonitors {
 public:
  /// Throws std::runtime_error where there is no Xorg with the driver "dummy", or it may not run.
  XMonitors();

  const std::string& display() const { return server_.display(); }
  void take_away(const std::string& monitor);
  void bring_back(const std::string& monitor);

 private:
  TemporaryFolder folder_;  ///< of the server's settings and its log
  XServer server_;
};

/// A program that frames windows and gives them the keyboard, for as long as it lives.
class WindowManager {
 public:
  /// "openbox", where a window gets the keyboard when it opens or is clicked; or "twm", where it
  /// has it while the pointer is in it. Returns once it manages the display's windows; throws
  /// std::runtime_error if it never does.
  WindowManager(const std::string& name, const std::string& display);
  ~WindowManager();
  WindowManager(const WindowManager&) = delete;
  WindowManager& operator=(const WindowManager&) = delete;

 private:
  TemporaryFolder folder_;  ///< of its settings
  pid_t process_ = -1;
};

/// A user, through the extension XTest. A window of `title` is waited for where one is named;
/// throws std::runtime_error if there never is one.
class XUser {
 public:
  explicit XUser(const std::string& display);
  ~XUser();
  XUser(const XUser&) = delete;
  XUser& operator=(const XUser&) = delete;

  /// Presses a key and lets it go; by its name, as in X11/keysymdef.h without XK_.
  void type(const std::string& key);
  void hold(const std::string& key);
  void let_go(const std::string& key);
  /// Holds it, waits until that is done, and returns the server's time right after, as it tells
  /// every client: ms of its own clock, modulo 2^32.
  std::uint32_t hold_and_ask_time(const std::string& key);
  /// Waits until the server has done all that was asked of it so far.
  void settle();
  void press_button(unsigned button);
  void release_button(unsigned button);
  /// In the window, from its top left corner.
  void point_at(const std::string& title, int x, int y);
  void resize(const std::string& title, unsigned width, unsigned height);
  /// The window's on the whole desktop.
  struct Place {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
  };
  Place place_of(const std::string& title);
  /// How bright the window's pixel is that the user sees there, from its top left corner: the mean
  /// of its components, from 0 to 1.
  double brightness_at(const std::string& title, int x, int y);
  /// Types into the window from now on, as after a click into it.
  void focus(const std::string& title);
  /// The same into a window of another program.
  void focus_elsewhere();
  /// A second pointer of that name, with a keyboard.
  void plug_in_pointer(std::string name);
  /// As a window manager asks when its cross is clicked.
  void ask_to_close(const std::string& title);
  /// As a window manager says of a minimised window.
  void say_minimised(const std::string& title, bool is_minimised);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace foveola::test
