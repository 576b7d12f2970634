// Watches the computer's clocks during a session: the wall clock may be set, and the computer may
// sleep, which stops the session's clock.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/clock.h"

namespace foveola::study {

class SessionDriver;

/// One moment by three clocks.
struct ClockReadings {
  Nanoseconds steady{0};      ///< CLOCK_MONOTONIC, the session's: stops in sleep
  Nanoseconds since_boot{0};  ///< CLOCK_BOOTTIME: continues in sleep
  Nanoseconds since_1970{0};  ///< CLOCK_REALTIME: may be set
};

/// Reads the clocks, in less than a microsecond.
ClockReadings read_clocks();

class ClockWatch {
 public:
  explicit ClockWatch(const ClockReadings& start) : start_(start) {}

  /// Returns the record's notes of new findings: the computer slept, or the wall clock's offset
  /// from the session's has changed by more than 5 s.
  std::vector<std::string> notes_until(const ClockReadings& now);

 private:
  ClockReadings start_;  ///< shifted by the noted changes
};

/// Writes the notes into the session, and has the current attempt retimed.
void follow_clocks(ClockWatch& watch, const ClockReadings& now, SessionDriver& driver);

}  // namespace foveola::study
