#include "renderer/window/x_display.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <span>
#include <sstream>
#include <string_view>
#include <vector>

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/extensions/XInput.h>
#include <fmt/format.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/text/print.h"

namespace foveola {
namespace {

/// Every release names its keyboards and pointers "xwayland-keyboard:16" and so on; its own
/// extension XWAYLAND exists since 23.1.
bool is_xwayland(Display* display) {
  int count = 0;
  const std::unique_ptr<XDeviceInfo, decltype(&XFreeDeviceList)> devices(
      XListInputDevices(display, &count), &XFreeDeviceList);
  return std::ranges::any_of(
      std::span(devices.get(), static_cast<std::size_t>(count)), [](const XDeviceInfo& device) {
        return device.name != nullptr && std::string_view(device.name).starts_with("xwayland-");
      });
}

/// The strings of XKB's property of the root window: rules, model, layouts, variants, options.
std::vector<std::string> keyboard_names(Display* display) {
  const Atom name = XInternAtom(display, "_XKB_RULES_NAMES", True);
  Atom type = 0;
  int format = 0;
  unsigned long count = 0;
  unsigned long left = 0;
  unsigned char* bytes = nullptr;
  constexpr long max_words = 256;
  std::vector<std::string> names;
  if (name != 0 &&
      XGetWindowProperty(display, DefaultRootWindow(display), name, 0, max_words, 0, XA_STRING,
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
  const std::vector<std::string> names = keyboard_names(display.get());
  return {.windows = is_xwayland(display.get()) ? "XWayland" : "X11",
          .keyboard_layout = names.size() < 4 ? "" : with_variants(names[2], names[3])};
}

/// Data for ending the program. The drawing thread may notice the loss as well as the one that
/// waits for events.
struct LostDisplay::Ending {
  std::string line;
  std::atomic_flag was_said;

  /// Ends the program without C++'s clean-up, since other threads are still running.
  [[noreturn]] static void end(Display* /*display*/, void* data) {
    constexpr int user_error = 1;
    auto& ending = *static_cast<Ending*>(data);
    if (!ending.was_said.test_and_set()) {
      print_text(stderr, "{}", ending.line);
    }
    ::_exit(user_error);
  }
};

LostDisplay::LostDisplay(std::string remedy)
    : ending_(new Ending{.line = fmt::format(
                             "foveola: error: {}\n",
                             Error("window", "the connection to the display broke", remedy).what()),
                         .was_said = {}}) {
  if (Display* const display = glfwGetX11Display()) {
    XSetIOErrorHandler([](Display*) { return 0; });  // replaces the handler that prints
    XSetIOErrorExitHandler(display, Ending::end, ending_.get());
  }
}

LostDisplay::~LostDisplay() {
  if (Display* const display = glfwGetX11Display()) {
    XSetIOErrorHandler(nullptr);
    XSetIOErrorExitHandler(display, nullptr, nullptr);
  }
}

}  // namespace foveola
