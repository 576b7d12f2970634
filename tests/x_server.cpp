#include "tests/x_server.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <vector>

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace foveola::test {

XServer::XServer() {
  std::array<int, 2> number_pipe{};
  if (::pipe(number_pipe.data()) != 0) {
    throw std::runtime_error("no pipe");
  }
  const std::string number_end = std::to_string(number_pipe[1]);
  process_ = ::fork();
  if (process_ == 0) {
    ::close(number_pipe[0]);
    ::execlp("Xvfb", "Xvfb", "-displayfd", number_end.c_str(), "-screen", "0", "1280x1024x24",
             "-nolisten", "tcp", "-noreset", nullptr);
    ::_exit(127);
  }
  ::close(number_pipe[1]);
  display_ = ":";
  char digit = 0;
  while (::read(number_pipe[0], &digit, 1) == 1 && digit != '\n') {
    display_ += digit;
  }
  ::close(number_pipe[0]);
  if (digit != '\n') {
    throw std::runtime_error("Xvfb does not start");
  }
  ::setenv("DISPLAY", display_.c_str(), 1);
  ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  // Programs that draw with Mesa leave its memory behind, in libraries that are gone at their end.
  ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
}

XServer::~XServer() {
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

struct XUser::Connection {
  explicit Connection(const std::string& name) : display(XOpenDisplay(name.c_str())) {
    if (display == nullptr) {
      throw std::runtime_error("no X server at " + name);
    }
  }
  ~Connection() { XCloseDisplay(display); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// 0 if there is none, or it is not shown yet.
  ::Window find(const std::string& title) const {
    ::Window root = 0;
    ::Window parent = 0;
    ::Window* children = nullptr;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
    ::Window found = 0;
    for (unsigned i = 0; i < count; ++i) {
      char* name = nullptr;
      XWindowAttributes attributes{};
      if (XFetchName(display, children[i], &name) != 0 && name == title &&
          XGetWindowAttributes(display, children[i], &attributes) != 0 &&
          attributes.map_state == IsViewable) {
        found = children[i];
      }
      XFree(name);
    }
    XFree(children);
    return found;
  }

  ::Window wait_for(const std::string& title) const {
    for (int i = 0; i < 1000; ++i) {
      if (const ::Window found = find(title)) {
        return found;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    throw std::runtime_error("there is no window '" + title + "'");
  }

  void key(const std::string& name, bool is_down) const {
    const KeySym symbol = XStringToKeysym(name.c_str());
    if (symbol == NoSymbol) {
      throw std::runtime_error("there is no key '" + name + "'");
    }
    XTestFakeKeyEvent(display, XKeysymToKeycode(display, symbol), is_down ? True : False,
                      CurrentTime);
    XFlush(display);
  }

  Display* display;
};

XUser::XUser(const std::string& display) : connection_(std::make_unique<Connection>(display)) {}

XUser::~XUser() = default;

void XUser::type(const std::string& key) {
  hold(key);
  let_go(key);
}

void XUser::hold(const std::string& key) { connection_->key(key, true); }

void XUser::let_go(const std::string& key) { connection_->key(key, false); }

void XUser::press_button(unsigned button) {
  XTestFakeButtonEvent(connection_->display, button, True, CurrentTime);
  XFlush(connection_->display);
}

void XUser::release_button(unsigned button) {
  XTestFakeButtonEvent(connection_->display, button, False, CurrentTime);
  XFlush(connection_->display);
}

void XUser::point_at(const std::string& title, int x, int y) {
  Display* const display = connection_->display;
  int root_x = 0;
  int root_y = 0;
  ::Window child = 0;
  XTranslateCoordinates(display, connection_->wait_for(title), DefaultRootWindow(display), x, y,
                        &root_x, &root_y, &child);
  XTestFakeMotionEvent(display, DefaultScreen(display), root_x, root_y, CurrentTime);
  XFlush(display);
}

void XUser::resize(const std::string& title, unsigned width, unsigned height) {
  XResizeWindow(connection_->display, connection_->wait_for(title), width, height);
  XFlush(connection_->display);
}

void XUser::ask_to_close(const std::string& title) {
  Display* const display = connection_->display;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = connection_->wait_for(title);
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
  XSendEvent(display, event.xclient.window, False, NoEventMask, &event);
  XFlush(display);
}

void XUser::say_minimised(const std::string& title, bool is_minimised) {
  Display* const display = connection_->display;
  const Atom state = XInternAtom(display, "WM_STATE", False);
  const std::array<long, 2> value = {is_minimised ? IconicState : NormalState, None};
  XChangeProperty(display, connection_->wait_for(title), state, state, 32, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(value.data()), value.size());
  XFlush(display);
}

}  // namespace foveola::test
