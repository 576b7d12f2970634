#include "renderer/gaze/pointer_eye_tracker.h"

#include <algorithm>
#include <chrono>

namespace foveola {
namespace {

constexpr Nanoseconds interval = std::chrono::milliseconds(8);
/// Nobody who has not asked for so long wants to know all that was meanwhile.
constexpr Nanoseconds longest_gap = std::chrono::seconds(5);

}  // namespace

void PointerEyeTracker::point_at(Nanoseconds time, const std::optional<Vec3>& direction) {
  GazeSample event{.time = time, .valid = direction.has_value()};
  event.direction = direction.value_or(event.direction);
  const std::lock_guard lock(mutex_);
  events_.push_back(event);
  const auto is_recent = [&](const GazeSample& e) { return time - e.time <= longest_gap; };
  const auto recent = std::find_if(events_.cbegin(), events_.cend(), is_recent);
  if (recent != events_.cbegin()) {
    events_.erase(events_.cbegin(), std::prev(recent));  // keeps where it was before
  }
}

void PointerEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const std::lock_guard lock(mutex_);
  if (events_.empty()) {
    return;
  }
  // An event may come between `now` and this call.
  const Nanoseconds newest = std::max(events_.back().time, now);
  const Nanoseconds gap = newest - last_sample_.value_or(newest);
  const auto samples =
      gap > longest_gap ? 1 : std::max<std::int64_t>(1, (gap + interval / 2) / interval);
  auto event = events_.cbegin();
  for (std::int64_t left = samples - 1; left >= 0; --left) {
    const Nanoseconds time = newest - left * gap / samples;
    while (std::next(event) != events_.cend() && std::next(event)->time <= time) {
      ++event;
    }
    if (event->time <= time) {
      arrived.push_back(*event);
      arrived.back().time = time;
    }
  }
  events_.erase(events_.cbegin(), std::prev(events_.cend()));
  last_sample_ = newest;
}

}  // namespace foveola
