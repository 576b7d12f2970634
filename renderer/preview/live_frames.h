// Frames on a clock: as many samples as the display's next refresh leaves time for.
#pragma once

#include <cstdint>
#include <functional>

#include "renderer/base/clock.h"
#include "renderer/preview/frame_budget.h"
#include "renderer/preview/preview.h"

namespace foveola {

/// When a frame's work was done, and how long each part took.
struct LiveFrame {
  FrameReport report;
  Nanoseconds start{0};     ///< the refresh before, or when that was found to be over
  Nanoseconds deadline{0};  ///< the refresh that it should be ready for
  Nanoseconds polling{0};   ///< head and gaze, and aiming the sampler
  Nanoseconds tracing{0};   ///< from directions to film
  Nanoseconds presenting{0};
  std::uint64_t missed_refreshes = 0;  ///< that showed the frame before once more

  bool is_late() const { return missed_refreshes > 0; }
};

/// Renders a frame a refresh. Late frames are told, and the next one begins at the next refresh.
class LiveFrames {
 public:
  /// Returns at `time`, or at once if that is over.
  using WaitUntil = std::function<void(Nanoseconds time)>;
  /// Shows what the preview knows; returns when it is done with the film.
  using Present = std::function<void(const Preview& preview)>;

  /// refresh_rate_hz: > 0. The first refresh is now. Preview and clock must outlive it.
  LiveFrames(Preview& preview, const Clock& clock, double refresh_rate_hz, WaitUntil wait_until,
             Present present);

  /// Waits for the next refresh, and renders and presents a frame.
  LiveFrame next();

 private:
  void trace(LiveFrame& frame);
  void trace_batch(std::uint64_t samples, LiveFrame& frame);

  Preview* preview_;
  const Clock* clock_;
  WaitUntil wait_until_;
  Present present_;
  Nanoseconds refresh_interval_;
  Nanoseconds next_refresh_;
  FrameBudget budget_;
};

}  // namespace foveola
