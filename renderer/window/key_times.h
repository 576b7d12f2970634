// When keys moved: by the X server's stamps, not by when this program read them.
//
// The thread that draws shares the connection to the server, and cores that trace are busy: an
// event lies unread for up to ten milliseconds. The server stamps each as it comes, in milliseconds
// of CLOCK_MONOTONIC if it runs on this machine (GetTimeInMillis in the X.Org server's os/utils.c).
// GLFW keeps the stamps to itself, so they are noted as Xlib reads the events.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "renderer/base/clock.h"

struct GLFWwindow;

namespace foveola {

/// What the times of keys are.
enum class KeyTimeSource {
  server_stamp,  ///< a millisecond of the server's, at its end, or the arrival if that was earlier
  arrival,       ///< when the event was read: the server's clock is another
};
const char* name_of(KeyTimeSource source);

/// When an event happened that the server stamped `stamp_ms` and that was read at `arrival`: the
/// end of that millisecond, so never before it happened and at most 1 ms after it; `arrival` if it
/// was earlier, or if a stamp of this clock could not have been that long before it, or after it.
/// Stamps count modulo 2^32.
Nanoseconds time_of_stamp(std::uint32_t stamp_ms, Nanoseconds arrival);

/// Whether a stamp that was given between two moments is of the clock that measured these.
bool is_of_this_clock(std::uint32_t stamp_ms, Nanoseconds before, Nanoseconds after);

/// Notes the key events of GLFW's connection to the X server while it lives. For the thread that
/// waits for events; whichever thread reads them.
class KeyTimes {
 public:
  /// clock must outlive it; the window need not. Throws Error if GLFW has no connection to an X
  /// server.
  KeyTimes(GLFWwindow* window, const Clock& clock);
  ~KeyTimes();
  KeyTimes(const KeyTimes&) = delete;
  KeyTimes& operator=(const KeyTimes&) = delete;

  KeyTimeSource source() const;

  /// When the oldest event happened that was read of this key and has not been asked for; keycode
  /// is X11's, which GLFW calls scancode. Those before it are forgotten: GLFW had no use for them.
  /// Empty if there is none.
  std::optional<Nanoseconds> take(int keycode, bool is_down);

 private:
  struct Noted;
  std::unique_ptr<Noted> noted_;
};

}  // namespace foveola
