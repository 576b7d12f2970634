// What an X server says of the desktop behind it, and what happens when it goes away under a
// window.
#pragma once

#include <memory>
#include <string>

namespace foveola {

struct DesktopFacts {
  std::string windows;          ///< "X11" or "XWayland"
  std::string keyboard_layout;  ///< of XKB, as "us" or "de(nodeadkeys),ru"; empty if unknown
};

/// Of the server that windows are on, by a connection of its own; both empty if there is none.
DesktopFacts desktop_facts();

/// While it lives, the loss of the display ends the program with exit code 1 and one line on
/// standard error. Xlib can do no more than end the program then, and by itself would do so with
/// lines about its own insides. Where windows are not X's, it does nothing.
class LostDisplay {
 public:
  /// remedy: what the user can do about it, after "the connection to the display broke; ". GLFW
  /// must have been initialised, and be terminated later than this is destroyed.
  explicit LostDisplay(std::string remedy);
  ~LostDisplay();
  LostDisplay(const LostDisplay&) = delete;
  LostDisplay& operator=(const LostDisplay&) = delete;

 private:
  struct Ending;
  std::unique_ptr<Ending> ending_;
};

}  // namespace foveola
