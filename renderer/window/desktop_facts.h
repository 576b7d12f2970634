// What an X server says of the desktop behind it.
#pragma once

#include <string>

namespace foveola {

struct DesktopFacts {
  std::string windows;          ///< "X11" or "XWayland"
  std::string keyboard_layout;  ///< of XKB, as "us" or "de(nodeadkeys),ru"; empty if unknown
};

/// Of the server that windows are on, by a connection of its own; both empty if there is none.
DesktopFacts desktop_facts();

}  // namespace foveola
