// The pointer as an eye: gaze is where a user points.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// One thread may move the pointer while another asks for gaze. A pointer that rests sends no
/// events and is known to be where the last one put it, so its position is known at all times. The
/// newest sample is as of when it is asked for. Samples before it fill the time since the last call
/// evenly at a mouse's usual rate, 125 Hz, so that how well the gaze is known does not depend on
/// how often frames ask for it. How long a hand's movement takes to become an event is not in it.
class PointerEyeTracker final : public EyeTracker {
 public:
  /// The pointer is there from `time` on. direction: unit length, in the head's axes; empty when
  /// the pointer has left the window, which makes samples invalid until it is back.
  void point_at(Nanoseconds time, const std::optional<Vec3>& direction);

  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

 private:
  std::mutex mutex_;                        ///< guards the members below
  std::vector<GazeSample> events_;          ///< since the last call, after the newest one before it
  std::optional<Nanoseconds> last_sample_;  ///< time of the newest sample that was given
};

}  // namespace foveola
