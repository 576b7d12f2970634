#include "tests/x_server.h"

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XInput2.h>
#include <X11/extensions/XTest.h>
#include <X11/extensions/Xrandr.h>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/waiting.h"

namespace foveola::test {

XServer::XServer()
    : XServer({"Xvfb", "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset"}) {}

XServer::XServer(std::vector<std::string> command) {
  const TemporaryFolder folder;
  const std::filesystem::path said = folder.write("said", "");
  std::array<int, 2> number_pipe{};
  if (::pipe2(number_pipe.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error("no pipe");
  }
  const std::string program = command.front();
  command.emplace_back("-displayfd");
  command.push_back(std::to_string(number_pipe[1]));
  std::vector<char*> arguments;
  for (std::string& argument : command) {
    arguments.push_back(argument.data());
  }
  arguments.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // if a test dies, so does its server
    ::fcntl(number_pipe[1], F_SETFD, 0);
    const int to_file = ::open(said.c_str(), O_WRONLY);
    ::dup2(to_file, STDOUT_FILENO);
    ::dup2(to_file, STDERR_FILENO);
    ::execvp(arguments.front(), arguments.data());
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
    int status = 0;
    ::waitpid(process_, &status, 0);
    throw std::runtime_error(program + (WIFEXITED(status) && WEXITSTATUS(status) == 127
                                            ? " is not installed"
                                            : " does not start: " + folder.content()["said"]));
  }
  ::setenv("DISPLAY", display_.c_str(), 1);
  ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  // Programs that draw with Mesa leave its memory behind, in libraries that are gone at their end.
  ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
}

XServer::~XServer() { end(SIGTERM); }

void XServer::kill() { end(SIGKILL); }

void XServer::end(int signal) {
  if (process_ > 0) {
    ::kill(process_, signal);
    ::waitpid(process_, nullptr, 0);
    process_ = -1;
  }
}

namespace {

struct CloseDisplay {
  void operator()(Display* display) const { XCloseDisplay(display); }
};
using OpenDisplay = std::unique_ptr<Display, CloseDisplay>;

OpenDisplay open_display(const std::string& name) {
  OpenDisplay display(XOpenDisplay(name.c_str()));
  if (!display) {
    throw std::runtime_error("no X server at " + name);
  }
  // A window that is looked at may be gone by then.
  XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  return display;
}

/// Where a monitor stands, and which of its modes it shows.
struct MonitorPlace {
  const char* name;
  int left;
  unsigned width;
  unsigned height;
  int refresh_hz;  ///< rounded
};
constexpr std::array monitor_places = {MonitorPlace{"DUMMY0", 0, 1024, 768, 60},
                                       MonitorPlace{"DUMMY1", 1024, 800, 600, 56}};

const char* const settings_with_monitors = R"(
Section "ServerFlags"
  Option "AutoAddDevices" "false"
  Option "AutoAddGPU" "false"
EndSection
Section "Device"
  Identifier "device"
  Driver "dummy"
  VideoRam 65536
EndSection
Section "Screen"
  Identifier "screen"
  Device "device"
  DefaultDepth 24
  SubSection "Display"
    Depth 24
    Virtual 2560 1024
  EndSubSection
EndSection
)";

std::vector<std::string> command_with_monitors(const TemporaryFolder& folder) {
  // No console: neither is one needed, nor is there one in a container.
  return {"Xorg",
          "-config",
          folder.write("xorg.conf", settings_with_monitors),
          "-logfile",
          folder / "log",
          "-quiet",
          "-verbose",
          "0",
          "-sharevts",
          "-novtswitch",
          "-nolisten",
          "tcp",
          "-noreset"};
}

/// The outputs of a server and what they can show, through the extension RandR.
class Outputs {
 public:
  explicit Outputs(const std::string& display)
      : display_(open_display(display)),
        resources_(XRRGetScreenResources(display_.get(), DefaultRootWindow(display_.get()))) {}
  ~Outputs() { XRRFreeScreenResources(resources_); }
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  void make_room(int width, int height) const {
    constexpr double mm_per_pixel = 0.25;
    XRRSetScreenSize(display_.get(), DefaultRootWindow(display_.get()), width, height,
                     static_cast<int>(mm_per_pixel * width),
                     static_cast<int>(mm_per_pixel * height));
  }

  void show(const MonitorPlace& place, bool is_there) const {
    RROutput output = output_of(place.name);
    XRROutputInfo* const info = XRRGetOutputInfo(display_.get(), resources_, output);
    const RRCrtc crtc = info->crtcs[0];
    XRRFreeOutputInfo(info);
    const RRMode mode = is_there ? mode_of(place) : None;
    if (is_there) {
      XRRAddOutputMode(display_.get(), output, mode);
    }
    XRRSetCrtcConfig(display_.get(), resources_, crtc, CurrentTime, is_there ? place.left : 0, 0,
                     mode, RR_Rotate_0, &output, is_there ? 1 : 0);
    // The driver calls an output connected once it shows something, and is asked only here.
    XRRFreeScreenResources(
        XRRGetScreenResources(display_.get(), DefaultRootWindow(display_.get())));
  }

 private:
  RROutput output_of(const std::string& name) const {
    for (int i = 0; i < resources_->noutput; ++i) {
      XRROutputInfo* const info =
          XRRGetOutputInfo(display_.get(), resources_, resources_->outputs[i]);
      const bool is_it = name == info->name;
      XRRFreeOutputInfo(info);
      if (is_it) {
        return resources_->outputs[i];
      }
    }
    throw std::runtime_error("there is no output " + name);
  }

  RRMode mode_of(const MonitorPlace& place) const {
    for (int i = 0; i < resources_->nmode; ++i) {
      const XRRModeInfo& mode = resources_->modes[i];
      const double refresh_hz = static_cast<double>(mode.dotClock) / mode.hTotal / mode.vTotal;
      if (mode.width == place.width && mode.height == place.height &&
          std::lround(refresh_hz) == place.refresh_hz) {
        return mode.id;
      }
    }
    throw std::runtime_error("there is no such mode");
  }

  OpenDisplay display_;
  XRRScreenResources* resources_;
};

const MonitorPlace& place_of(const std::string& monitor) {
  for (const MonitorPlace& place : monitor_places) {
    if (monitor == place.name) {
      return place;
    }
  }
  throw std::runtime_error("there is no monitor " + monitor);
}

}  // namespace

XMonitors::XMonitors() : server_(command_with_monitors(folder_)) {
  Outputs(display()).make_room(1824, 768);
  for (const MonitorPlace& place : monitor_places) {
    bring_back(place.name);
  }
}

void XMonitors::take_away(const std::string& monitor) {
  Outputs(display()).show(place_of(monitor), false);
}

void XMonitors::bring_back(const std::string& monitor) {
  Outputs(display()).show(place_of(monitor), true);
}

WindowManager::WindowManager(const std::string& name, const std::string& display) {
  // twm would wait for a click to place each window.
  const std::string settings = folder_.write("twmrc", "RandomPlacement\nNoGrabServer\n");
  const OpenDisplay opened = open_display(display);
  process_ = ::fork();
  if (process_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    const bool is_twm = name == "twm";
    ::execlp(name.c_str(), name.c_str(), is_twm ? "-f" : "--sm-disable",
             is_twm ? settings.c_str() : nullptr, nullptr);
    ::_exit(127);
  }
  wait_until("windows managed by " + name, [&] {
    XWindowAttributes root{};
    XGetWindowAttributes(opened.get(), DefaultRootWindow(opened.get()), &root);
    return (root.all_event_masks & SubstructureRedirectMask) != 0;
  });
}

WindowManager::~WindowManager() {
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

struct XUser::Connection {
  explicit Connection(const std::string& name)
      : opened(open_display(name)), display(opened.get()) {}

  /// 0 if there is none, or it is not shown yet. A window manager puts it into a frame.
  ::Window find(const std::string& title) const {
    return find_in(DefaultRootWindow(display), title);
  }

  ::Window find_in(::Window parent, const std::string& title) const {
    ::Window root = 0;
    ::Window grandparent = 0;
    ::Window* children = nullptr;
    unsigned count = 0;
    XQueryTree(display, parent, &root, &grandparent, &children, &count);
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
      found = found == 0 ? find_in(children[i], title) : found;
    }
    XFree(children);
    return found;
  }

  ::Window wait_for(const std::string& title) const {
    ::Window found = 0;
    wait_until("a window '" + title + "'", [&] {
      found = find(title);
      return found != 0;
    });
    return found;
  }

  void key(const std::string& name, bool is_down) const {
    fake_key(name, is_down);
    XFlush(display);
  }

  /// Asked for once something else is.
  void fake_key(const std::string& name, bool is_down) const {
    const KeySym symbol = XStringToKeysym(name.c_str());
    if (symbol == NoSymbol) {
      throw std::runtime_error("there is no key '" + name + "'");
    }
    XTestFakeKeyEvent(display, XKeysymToKeycode(display, symbol), is_down ? True : False,
                      CurrentTime);
  }

  /// By an event that a window's property was changed, of a window that nobody sees.
  std::uint32_t time() const {
    if (hidden == 0) {
      hidden = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
      XSelectInput(display, hidden, PropertyChangeMask);
    }
    XChangeProperty(display, hidden, XA_WM_NAME, XA_STRING, 8, PropModeAppend, nullptr, 0);
    XEvent changed{};
    XWindowEvent(display, hidden, PropertyChangeMask, &changed);
    return static_cast<std::uint32_t>(changed.xproperty.time);
  }

  OpenDisplay opened;
  Display* display;
  mutable ::Window hidden = 0;
};

XUser::XUser(const std::string& display) : connection_(std::make_unique<Connection>(display)) {
  // On a busy machine a key may be held long enough to repeat.
  XAutoRepeatOff(connection_->display);
}

XUser::~XUser() = default;

void XUser::type(const std::string& key) {
  hold(key);
  let_go(key);
}

void XUser::hold(const std::string& key) { connection_->key(key, true); }

void XUser::let_go(const std::string& key) { connection_->key(key, false); }

std::uint32_t XUser::hold_and_ask_time(const std::string& key) {
  connection_->fake_key(key, true);
  return connection_->time();
}

void XUser::settle() { XSync(connection_->display, False); }

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

XUser::Place XUser::place_of(const std::string& title) {
  XWindowAttributes attributes{};
  XGetWindowAttributes(connection_->display, connection_->wait_for(title), &attributes);
  return {attributes.x, attributes.y, attributes.width, attributes.height};
}

double XUser::brightness_at(const std::string& title, int x, int y) {
  XImage* const image =
      XGetImage(connection_->display, connection_->wait_for(title), x, y, 1, 1, AllPlanes, ZPixmap);
  if (image == nullptr) {
    throw std::runtime_error("the window has no such pixel");
  }
  const unsigned long pixel = XGetPixel(image, 0, 0);  // of a screen of 24 bits: 0xRRGGBB
  XDestroyImage(image);
  return static_cast<double>((pixel >> 16U & 255U) + (pixel >> 8U & 255U) + (pixel & 255U)) /
         (3.0 * 255.0);
}

void XUser::focus(const std::string& title) {
  XSetInputFocus(connection_->display, connection_->wait_for(title), RevertToPointerRoot,
                 CurrentTime);
  XFlush(connection_->display);
}

void XUser::focus_elsewhere() {
  const char* const title = "Another program's window";
  Display* const display = connection_->display;
  if (connection_->find(title) == 0) {
    const ::Window other =
        XCreateSimpleWindow(display, DefaultRootWindow(display), 900, 700, 100, 100, 0, 0, 0);
    XStoreName(display, other, title);
    XMapWindow(display, other);
  }
  focus(title);
}

void XUser::plug_in_pointer(std::string name) {
  XIAnyHierarchyChangeInfo change{};
  change.add = {.type = XIAddMaster, .name = name.data(), .send_core = False, .enable = True};
  if (XIChangeHierarchy(connection_->display, &change, 1) != Success) {
    throw std::runtime_error("the server takes no pointer");
  }
  settle();
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
