#include "renderer/gaze/clock_alignment.h"

#include <cassert>

namespace foveola {

ClockAlignment::ClockAlignment(Nanoseconds window) : offsets_(window) {
  assert(window > Nanoseconds::zero());
}

Nanoseconds ClockAlignment::host_time(Nanoseconds tracker_time, Nanoseconds arrival) {
  if (last_tracker_time_ && tracker_time < *last_tracker_time_) {
    offsets_.clear();
  }
  last_tracker_time_ = tracker_time;
  offsets_.add(arrival, arrival - tracker_time);
  return tracker_time + offsets_.least();
}

}  // namespace foveola
