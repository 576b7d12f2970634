// The tracker under test with all that it ever said.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <latch>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/hid_eye_tracker.h"

namespace foveola::test {

/// Reads the attached eye tracker of a product with HidEyeTracker, and keeps each of its samples.
class WatchedTracker {
 public:
  /// settings: of the tracker.
  WatchedTracker(std::uint16_t product_id, const HidTrackerSettings& settings);

  HidTrackerState state() const { return tracker_.state(); }

  /// Waits until the tracker's state is such; throws if it never is.
  HidTrackerState wait_for(const std::string& what,
                           const std::function<bool(const HidTrackerState&)>& is_reached) const;

  /// Waits until there have been so many samples and returns all; throws if there never are.
  std::vector<GazeSample> wait_for_samples(std::size_t count) const;

 private:
  class WatchedDevice;
  std::optional<HidConnection> open(std::uint16_t product_id);
  void keep_arrived();

  SteadyClock clock_;
  mutable std::mutex mutex_;  ///< of the next
  std::vector<GazeSample> samples_;
  std::latch is_made_{1};  ///< the tracker, whose thread looks at it
  HidEyeTracker tracker_;
};

}  // namespace foveola::test
