#include "renderer/gaze/pointer_eye_tracker.h"

#include <algorithm>

namespace foveola {

void PointerEyeTracker::point_at(Nanoseconds time, const std::optional<Vec3>& direction) {
  GazeSample event{.time = time, .valid = direction.has_value()};
  event.direction = direction.value_or(event.direction);
  const std::lock_guard lock(mutex_);
  last_event_ = event;
}

std::optional<GazeSample> PointerEyeTracker::newest(Nanoseconds now) {
  const std::lock_guard lock(mutex_);
  std::optional<GazeSample> sample = last_event_;
  if (sample) {
    // An event may come between `now` and this call.
    sample->time = std::max(sample->time, now);
  }
  return sample;
}

}  // namespace foveola
