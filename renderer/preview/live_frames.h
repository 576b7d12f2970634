// Frames paced by a clock: as many samples as fit before the display's next refresh, and each
// frame's latency from the eye's movement to light.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "renderer/base/clock.h"
#include "renderer/gaze/latency.h"
#include "renderer/gaze/profiles.h"
#include "renderer/preview/frame_budget.h"
#include "renderer/preview/preview.h"

namespace foveola {

/// The times of a frame's stages.
struct LiveFrame {
  FrameReport report;
  Nanoseconds start{0};       ///< the refresh before, or when that was found to have passed
  Nanoseconds deadline{0};    ///< the refresh that it is aimed at
  Nanoseconds polling{0};     ///< head and gaze, and aiming the sampler
  Nanoseconds tracing{0};     ///< from directions to film, including the film's own work
  Nanoseconds resampling{0};  ///< from film to the display's image
  Nanoseconds presenting{0};  ///< handover, including a wait for a refresh
  Nanoseconds shown{0};       ///< the refresh that shows it
  std::uint64_t missed_refreshes = 0;  ///< number of refreshes that repeated the frame before
  bool is_refresh_measured = false;    ///< otherwise refreshes are assumed at the nominal rate

  bool is_late() const { return missed_refreshes > 0; }
};

/// The path of frames to the display.
struct FrameOutput {
  /// Makes the display's image from the preview; returns when it no longer needs the film.
  std::function<void(Preview& preview)> resample;
  /// Hands the image over. If it waits until the display takes it at a refresh, returns that time
  /// promptly; otherwise nullopt.
  std::function<std::optional<Nanoseconds>()> present;
};

/// Renders one frame per refresh, or per several if drawing leaves too little time (see
/// FrameBudget). Late frames are reported, and the next one begins at the next refresh. Refreshes
/// are estimated from the output's waits; without waits they are assumed at the nominal rate from
/// now on.
class LiveFrames {
 public:
  /// Returns at `time`, or at once if it has passed.
  using WaitUntil = std::function<void(Nanoseconds time)>;

  /// refresh, budget: estimates of the display and the costs so far. Preview and clock must outlive
  /// the frames.
  LiveFrames(Preview& preview, const Clock& clock, const RefreshEstimator& refresh,
             WaitUntil wait_until, FrameOutput output, const FrameBudget& budget = FrameBudget());

  /// Waits for the next refresh, and renders and presents a frame.
  LiveFrame next();

  /// Yields the processor to other work: frames then trace next to nothing, and skip refreshes.
  void give_way(bool gives_way) { gives_way_ = gives_way; }

  /// The current estimate of refreshes.
  const RefreshEstimator& refresh() const { return refresh_; }

  /// The current estimate of frames' costs.
  const FrameBudget& budget() const { return budget_; }

  /// A frame's time besides tracing, while it is too long for frames to be in time.
  std::optional<Nanoseconds> too_slow_drawing() const;

 private:
  void trace(LiveFrame& frame);
  void trace_batch(std::uint64_t samples, LiveFrame& frame);
  void show(LiveFrame& frame);
  void note_shown_at(Nanoseconds refresh, LiveFrame& frame) const;
  /// The refresh that shows a frame that was ready at `end`, if known by the clock alone; `end`
  /// itself if drawing is too slow for the clock's pace.
  Nanoseconds assumed_refresh(const LiveFrame& frame, Nanoseconds end) const;

  Preview* preview_;
  const Clock* clock_;
  RefreshEstimator refresh_;
  WaitUntil wait_until_;
  FrameOutput output_;
  Nanoseconds next_refresh_;
  FrameBudget budget_;
  bool gives_way_ = false;
};

/// Whether the frame follows the eye, and so has a latency: its gaze is the tracker's newest
/// sample, and valid. Others hold the gaze through a blink, or because it is frozen.
bool follows_eye(const FrameReport& report);

/// The latency of a frame that follows the eye, by this tracker and on this display. Each stage has
/// its actual duration; only the exposure has a best and a worst case. Their sum is the age of the
/// gaze, which is measured, and the time from its use until the frame was lit.
///
/// - exposure, transfer, processing, scan-out: from the profiles;
/// - waiting for the frame: the rest of the gaze's age, measured;
/// - tracing: measured, with polling, aiming, and numbering and adding up samples in the film;
/// - film and resample: the display's image, measured;
/// - present: until the refresh that shows the frame, as well known as that is.
LatencyStages frame_latency(const LiveFrame& frame, const TrackerProfile& tracker,
                            const DisplayProfile& display);

/// Maximum expected age of a gaze at its use. An image's data arrive after the rest of its
/// exposure, transfer and processing, and are then the newest for one period of the tracker.
double gaze_age_limit_s(const TrackerProfile& tracker);

}  // namespace foveola
