// Facts of an X server and its desktop, and handling of its loss under a window.
#pragma once

#include <memory>
#include <string>

namespace foveola {

struct DesktopFacts {
  std::string windows;          ///< "X11" or "XWayland"
  std::string keyboard_layout;  ///< of XKB, as "us" or "de(nodeadkeys),ru"; empty if unknown
};

/// Of the windows' server, by a separate connection; both empty without one.
DesktopFacts desktop_facts();

/// While it lives, the loss of the display ends the program with exit code 1 and one line on
/// standard error. Xlib must end the program then, and by itself would print lines about its
/// internals. Without X it does nothing.
class LostDisplay {
 public:
  /// remedy: for the user, after "the connection to the display broke; ". GLFW must be initialised
  /// before, and terminated after this is destroyed.
  explicit LostDisplay(std::string remedy);
  ~LostDisplay();
  LostDisplay(const LostDisplay&) = delete;
  LostDisplay& operator=(const LostDisplay&) = delete;

 private:
  struct Ending;
  std::unique_ptr<Ending> ending_;
};

}  // namespace foveola
