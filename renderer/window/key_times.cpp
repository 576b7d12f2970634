#include "renderer/window/key_times.h"

#include <algorithm>
#include <array>
#include <deque>
#include <mutex>

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xlibint.h>

#undef max
#undef min

#include "renderer/base/error.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

/// Maximum plausible age of a stamp at its event's arrival: the program may have been stopped.
constexpr std::uint32_t oldest_stamp_ms = 10'000;
/// The server's clock may go by ticks up to this length.
constexpr std::int32_t longest_tick_ms = 1;

std::int64_t whole_ms(Nanoseconds time) { return std::chrono::floor<milliseconds>(time).count(); }

/// The stamp of an event that the server sends at once.
std::optional<std::uint32_t> asked_stamp(Display* display, ::Window window) {
  const Atom name = XInternAtom(display, "FOVEOLA_TIME", False);
  XChangeProperty(display, window, name, XA_STRING, 8, PropModeAppend, nullptr, 0);
  XSync(display, False);
  struct Wanted {
    ::Window window;
    Atom name;
  } wanted{window, name};
  const auto is_wanted = [](Display*, XEvent* event, XPointer pointer) -> Bool {
    const auto* sought = reinterpret_cast<const Wanted*>(pointer);
    return event->type == PropertyNotify && event->xproperty.window == sought->window &&
           event->xproperty.atom == sought->name;
  };
  XEvent event{};
  if (XCheckIfEvent(display, &event, is_wanted, reinterpret_cast<XPointer>(&wanted)) == False) {
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(event.xproperty.time);
}

KeyTimeSource source_for(Display* display, ::Window window, const Clock& clock) {
  const Nanoseconds before = clock.now();
  const std::optional<std::uint32_t> stamp_ms = asked_stamp(display, window);
  return stamp_ms && is_of_this_clock(*stamp_ms, before, clock.now()) ? KeyTimeSource::server_stamp
                                                                      : KeyTimeSource::arrival;
}

}  // namespace

const char* name_of(KeyTimeSource source) {
  return source == KeyTimeSource::server_stamp ? "server_stamp" : "arrival";
}

Nanoseconds time_of_stamp(std::uint32_t stamp_ms, Nanoseconds arrival) {
  const std::int64_t arrival_ms = whole_ms(arrival);
  const std::uint32_t age_ms = static_cast<std::uint32_t>(arrival_ms) - stamp_ms;
  if (age_ms > oldest_stamp_ms) {
    return arrival;
  }
  return std::min<Nanoseconds>(arrival, milliseconds(arrival_ms - age_ms + 1));
}

bool is_of_this_clock(std::uint32_t stamp_ms, Nanoseconds before, Nanoseconds after) {
  const auto later_ms = [stamp_ms](Nanoseconds than) {
    return static_cast<std::int32_t>(stamp_ms - static_cast<std::uint32_t>(whole_ms(than)));
  };
  return later_ms(before) >= -longest_tick_ms && later_ms(after) <= 0;
}

/// Data attached to Xlib's connection. Xlib calls `note` for each event that it reads, in order,
/// with nothing but the connection.
struct KeyTimes::Noted {
  using Reader = Bool (*)(Display*, XEvent*, xEvent*);

  struct KeyEvent {
    int keycode = 0;
    bool is_down = false;
    Nanoseconds time{0};
  };
  static constexpr std::size_t max_events = 256;  ///< events not yet handled by GLFW

  Noted(Display* display_in, ::Window window, const Clock& clock_in)
      : display(display_in), clock(&clock_in), source(source_for(display_in, window, clock_in)) {
    hang_on();
    XLockDisplay(display);
    for (std::size_t i = 0; i < types.size(); ++i) {
      readers[i] = XESetWireToEvent(display, types[i], note);
    }
    XUnlockDisplay(display);
  }

  ~Noted() {
    XLockDisplay(display);
    for (std::size_t i = 0; i < types.size(); ++i) {
      XESetWireToEvent(display, types[i], readers[i]);
    }
    found_on(display)->private_data = nullptr;
    XUnlockDisplay(display);
  }

  Noted(const Noted&) = delete;
  Noted& operator=(const Noted&) = delete;

  /// Xlib frees the data when it closes the connection.
  void hang_on() {
    auto* const hung = static_cast<XExtData*>(std::calloc(1, sizeof(XExtData)));
    hung->number = XAddExtension(display)->extension;
    hung->free_private = leave;
    hung->private_data = reinterpret_cast<XPointer>(this);
    XAddToExtensionList(list_of(display), hung);
  }

  static XExtData** list_of(Display* of_display) {
    XEDataObject object{};
    object.display = of_display;
    return XEHeadOfExtensionList(object);
  }

  /// Recognised by `leave`, which only this data has. The newest comes first.
  static XExtData* found_on(Display* of_display) {
    XExtData* hung = *list_of(of_display);
    while (hung->free_private != leave) {
      hung = hung->next;
    }
    return hung;
  }

  static int leave(XExtData* /*hung*/) { return 0; }

  static Bool note(Display* of_display, XEvent* event, xEvent* wire) {
    auto* const noted = reinterpret_cast<Noted*>(found_on(of_display)->private_data);
    const bool is_down = (wire->u.u.type & 0x7f) == KeyPress;
    const Bool is_kept = noted->readers[is_down ? 0 : 1](of_display, event, wire);
    noted->add(event->xkey, is_down);
    return is_kept;
  }

  void add(const XKeyEvent& event, bool is_down) {
    const Nanoseconds arrival = clock->now();
    const Nanoseconds time = source == KeyTimeSource::server_stamp
                                 ? time_of_stamp(static_cast<std::uint32_t>(event.time), arrival)
                                 : arrival;
    const std::scoped_lock lock(mutex);
    events.push_back(
        {.keycode = static_cast<int>(event.keycode), .is_down = is_down, .time = time});
    if (events.size() > max_events) {
      events.pop_front();
    }
  }

  static constexpr std::array<int, 2> types{KeyPress, KeyRelease};

  Display* display;
  const Clock* clock;
  KeyTimeSource source;
  std::array<Reader, 2> readers{};  ///< Xlib's own, one per type
  std::mutex mutex;
  std::deque<KeyEvent> events;
};

KeyTimes::KeyTimes(GLFWwindow* window, const Clock& clock) {
  Display* const display = glfwGetX11Display();
  if (display == nullptr) {
    throw Error("window", "there is no connection to an X server", "run it under X11 or Xwayland");
  }
  noted_ = std::make_unique<Noted>(display, glfwGetX11Window(window), clock);
}

KeyTimes::~KeyTimes() = default;

KeyTimeSource KeyTimes::source() const { return noted_->source; }

std::optional<Nanoseconds> KeyTimes::take(int keycode, bool is_down) {
  const std::scoped_lock lock(noted_->mutex);
  std::deque<Noted::KeyEvent>& events = noted_->events;
  const auto found = std::ranges::find_if(events, [&](const Noted::KeyEvent& event) {
    return event.keycode == keycode && event.is_down == is_down;
  });
  if (found == events.end()) {
    return std::nullopt;
  }
  const Nanoseconds time = found->time;
  events.erase(events.begin(), std::next(found));
  return time;
}

}  // namespace foveola
