#include "renderer/window/lost_display.h"

#include <atomic>
#include <cstdio>
#include <utility>

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>
#include <X11/Xlib.h>
#include <fmt/format.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/print.h"

namespace foveola {

/// What the program ends with. The thread that draws may find the display gone as well as the one
/// that waits for events.
struct LostDisplay::Ending {
  std::string line;
  std::atomic_flag was_said;

  /// Ends the program without what C++ does at its end: other threads are in the middle of things.
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
    XSetIOErrorHandler([](Display*) { return 0; });  // in place of the one that prints
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
