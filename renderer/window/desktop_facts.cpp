#include "renderer/window/desktop_facts.h"

#include <memory>
#include <sstream>
#include <vector>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace foveola {
namespace {

/// The strings of XKB's property of the root window: rules, model, layouts, variants, options.
std::vector<std::string> keyboard_names(Display* display) {
  const Atom name = XInternAtom(display, "_XKB_RULES_NAMES", True);
  Atom type = 0;
  int format = 0;
  unsigned long count = 0;
  unsigned long left = 0;
  unsigned char* bytes = nullptr;
  constexpr long most_words = 256;
  std::vector<std::string> names;
  if (name != 0 &&
      XGetWindowProperty(display, DefaultRootWindow(display), name, 0, most_words, 0, XA_STRING,
                         &type, &format, &count, &left, &bytes) == 0 &&
      bytes != nullptr) {
    std::istringstream text(std::string(reinterpret_cast<char*>(bytes), count));
    for (std::string part; std::getline(text, part, '\0');) {
      names.push_back(part);
    }
    XFree(bytes);
  }
  return names;
}

/// "de,ru" and "nodeadkeys," as "de(nodeadkeys),ru".
std::string with_variants(const std::string& layouts, const std::string& variants) {
  std::istringstream all(layouts);
  std::istringstream own(variants);
  std::string text;
  for (std::string layout; std::getline(all, layout, ',');) {
    std::string variant;
    std::getline(own, variant, ',');
    text += (text.empty() ? "" : ",") + layout + (variant.empty() ? "" : "(" + variant + ")");
  }
  return text;
}

}  // namespace

DesktopFacts desktop_facts() {
  const std::unique_ptr<Display, decltype(&XCloseDisplay)> display(XOpenDisplay(nullptr),
                                                                   &XCloseDisplay);
  if (display == nullptr) {
    return {};
  }
  int opcode = 0;
  int event = 0;
  int error = 0;
  const bool is_xwayland = XQueryExtension(display.get(), "XWAYLAND", &opcode, &event, &error) != 0;
  const std::vector<std::string> names = keyboard_names(display.get());
  return {.windows = is_xwayland ? "XWayland" : "X11",
          .keyboard_layout = names.size() < 4 ? "" : with_variants(names[2], names[3])};
}

}  // namespace foveola
