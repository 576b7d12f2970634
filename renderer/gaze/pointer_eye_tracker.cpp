#include "renderer/gaze/pointer_eye_tracker.h"

#include <algorithm>

namespace foveola {

void PointerEyeTracker::point_at(Nanoseconds time, const std::optional<Vec3>& direction) {
  GazeSample event{.time = time, .valid = direction.has_value()};
  event.direction = direction.value_or(event.direction);
  const std::lock_guard lock(mutex_);
  last_event_ = event;
}

void PointerEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const std::lock_guard lock(mutex_);
  if (last_event_) {
    arrived.push_back(*last_event_);
    // An event may come between `now` and this call.
    arrived.back().time = std::max(last_event_->time, now);
  }
}

}  // namespace foveola
