#include "renderer/window/widened_eye_tracker.h"

#include <algorithm>

namespace foveola {

void WidenedEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const auto before = static_cast<std::ptrdiff_t>(arrived.size());
  source_->poll(now, arrived);
  if (times_ == 1.0) {
    return;
  }
  std::for_each(arrived.begin() + before, arrived.end(), [this](GazeSample& sample) {
    // What lies behind is on no screen.
    if (sample.valid && sample.direction.z < 0.0F) {
      const DVec3 seen(sample.direction);
      sample.direction = Vec3(glm::normalize(DVec3(times_ * seen.x, times_ * seen.y, seen.z)));
    }
  });
}

}  // namespace foveola
