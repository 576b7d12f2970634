// The runtime's clock, and which time of the script is when.
#pragma once

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {

/// The system's monotonic clock, but not its numbers: an application that takes the one for the
/// other should not get away with it.
XrTime now();

constexpr XrDuration nanoseconds(double seconds) {
  return static_cast<XrDuration>(seconds * 1e9 + (seconds < 0.0 ? -0.5 : 0.5));
}

/// Goes on evenly between the frames' display times, and beyond them.
double script_time_s(const Session& session, XrTime time);
/// When the first frame was waited for that is of this time or later.
XrTime time_of_script(const Session& session, double time_s);

/// Refuses what is no time, or so far from the latest frame that it must be another clock's.
void require_time(const Session& session, XrTime time);

}  // namespace foveola::test::openxr
