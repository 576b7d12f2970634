#include "renderer/gaze/clock_alignment.h"

#include <cassert>

namespace foveola {

ClockAlignment::ClockAlignment(Nanoseconds window) : window_(window) {
  assert(window > Nanoseconds::zero());
}

Nanoseconds ClockAlignment::host_time(Nanoseconds tracker_time, Nanoseconds arrival) {
  if (last_tracker_time_ && tracker_time < *last_tracker_time_) {
    fastest_.clear();
  }
  last_tracker_time_ = tracker_time;
  const Nanoseconds offset = arrival - tracker_time;
  while (!fastest_.empty() && fastest_.back().offset >= offset) {
    fastest_.pop_back();
  }
  fastest_.push_back({.arrival = arrival, .offset = offset});
  while (fastest_.front().arrival < arrival - window_) {
    fastest_.pop_front();
  }
  return tracker_time + fastest_.front().offset;
}

}  // namespace foveola
