// Times of key events by the X server's stamps, not by when this program read them.
//
// The drawing thread shares the connection to the server, and tracing keeps the cores busy: an
// event waits up to ten milliseconds to be read. The server stamps each on arrival, in milliseconds
// of CLOCK_MONOTONIC if it runs on this machine (GetTimeInMillis in the X.Org server's os/utils.c).
// GLFW does not pass the stamps on, so they are noted as Xlib reads the events.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "renderer/base/clock.h"

struct GLFWwindow;

namespace foveola {

/// The origin of key times.
enum class KeyTimeSource {
  server_stamp,  ///< end of the server's millisecond, or the arrival if that is earlier
  arrival,       ///< time of reading: the server has another clock
};
const char* name_of(KeyTimeSource source);

/// The time of an event that the server stamped `stamp_ms`, read at `arrival`: the end of that
/// millisecond, at most 1 ms after the event. `arrival` if that is earlier, or if the stamp is
/// impossible by this clock, too old or in the future. Stamps count modulo 2^32.
Nanoseconds time_of_stamp(std::uint32_t stamp_ms, Nanoseconds arrival);

/// Whether a stamp given between two moments is of the clock that measured these.
bool is_of_this_clock(std::uint32_t stamp_ms, Nanoseconds before, Nanoseconds after);

/// Notes the key events of GLFW's connection to the X server while it lives. For the thread that
/// waits for events; any thread may read them.
class KeyTimes {
 public:
  /// clock must outlive it; the window need not. Throws Error if GLFW has no connection to an X
  /// server.
  KeyTimes(GLFWwindow* window, const Clock& clock);
  ~KeyTimes();
  KeyTimes(const KeyTimes&) = delete;
  KeyTimes& operator=(const KeyTimes&) = delete;

  KeyTimeSource source() const;

  /// The time of the key's oldest event that was read and not yet taken; keycode is X11's, GLFW's
  /// scancode. Forgets earlier events, which GLFW ignored. nullopt if there is none.
  std::optional<Nanoseconds> take(int keycode, bool is_down);

 private:
  struct Noted;
  std::unique_ptr<Noted> noted_;
};

}  // namespace foveola
