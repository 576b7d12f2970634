// For tests that want to know only where a tracker says that the eye is now.
#pragma once

#include <optional>
#include <vector>

#include "renderer/gaze/eye_tracker.h"

namespace foveola::test {

/// What arrives at a tracker by `now`.
inline std::vector<GazeSample> polled(EyeTracker& tracker, Nanoseconds now) {
  std::vector<GazeSample> arrived;
  tracker.poll(now, arrived);
  return arrived;
}

/// Polls a tracker, which must outlive it.
class NewestGaze {
 public:
  explicit NewestGaze(EyeTracker& tracker) : tracker_(tracker) {}

  /// The newest sample that has arrived by `now`; empty before the first.
  std::optional<GazeSample> operator()(Nanoseconds now) {
    arrived_.clear();
    tracker_.poll(now, arrived_);
    if (!arrived_.empty()) {
      newest_ = arrived_.back();
    }
    return newest_;
  }

 private:
  EyeTracker& tracker_;
  std::vector<GazeSample> arrived_;
  std::optional<GazeSample> newest_;
};

}  // namespace foveola::test
