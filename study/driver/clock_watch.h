// Watches the computer's clocks while a session runs: somebody or a time server may set the wall
// clock, and the computer may sleep, in which the session's own clock stands still.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/clock.h"

namespace foveola::study {

class SessionDriver;

/// One moment by three clocks.
struct ClockReadings {
  Nanoseconds steady{0};      ///< CLOCK_MONOTONIC, the session's: stands still in sleep
  Nanoseconds since_boot{0};  ///< CLOCK_BOOTTIME: goes on in sleep
  Nanoseconds since_1970{0};  ///< CLOCK_REALTIME: may be set
};

/// Of now. Takes less than a microsecond.
ClockReadings read_clocks();

class ClockWatch {
 public:
  explicit ClockWatch(const ClockReadings& start) : start_(start) {}

  /// The record's notes of what happened since the last ones: the computer slept, or the wall clock
  /// and the session's have come more than 5 s apart in another way.
  std::vector<std::string> notes_until(const ClockReadings& now);

 private:
  ClockReadings start_;  ///< moved along by what was noted
};

/// Writes the notes into the session, and has the attempt that goes on timed again.
void follow_clocks(ClockWatch& watch, const ClockReadings& now, SessionDriver& driver);

}  // namespace foveola::study
