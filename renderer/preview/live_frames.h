// Frames on a clock: as many samples as the display's next refresh leaves time for, and the latency
// from the eye's movement to the light of each.
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

/// When the work of a frame was done, and how long each part took.
struct LiveFrame {
  FrameReport report;
  Nanoseconds start{0};       ///< the refresh before, or when that was found to be over
  Nanoseconds deadline{0};    ///< the refresh that it should be ready for
  Nanoseconds polling{0};     ///< head and gaze, and aiming the sampler
  Nanoseconds tracing{0};     ///< from directions to film, the film's own work included
  Nanoseconds resampling{0};  ///< from film to the display's image
  Nanoseconds presenting{0};  ///< handing it over, with the wait for a refresh if there was one
  Nanoseconds shown{0};       ///< the refresh that shows it
  std::uint64_t missed_refreshes = 0;  ///< refreshes that showed the frame before once more
  bool is_refresh_measured = false;    ///< else refreshes are assumed to come at the nominal rate

  bool is_late() const { return missed_refreshes > 0; }
};

/// How frames get to the display.
struct FrameOutput {
  /// Makes the display's image of what the preview knows; returns when it is done with the film.
  std::function<void(Preview& preview)> resample;
  /// Hands the image over. If it waits until the display has taken it, at a refresh: returns when
  /// that was, and does little else. Empty otherwise.
  std::function<std::optional<Nanoseconds>()> present;
};

/// Renders a frame a refresh, or as few refreshes as drawing leaves it time for (see FrameBudget).
/// Late frames are reported, and the next one begins at the next refresh.
/// Where refreshes are follows from when the output was done with frames, as far as it waits for
/// them; otherwise they are taken to come at the nominal rate from now on.
class LiveFrames {
 public:
  /// Returns at `time`, or at once if that is over.
  using WaitUntil = std::function<void(Nanoseconds time)>;

  /// refresh: the display's, with what it has learned already, as `budget` is.
  /// Preview and clock must outlive the frames.
  LiveFrames(Preview& preview, const Clock& clock, const RefreshEstimator& refresh,
             WaitUntil wait_until, FrameOutput output, const FrameBudget& budget = FrameBudget());

  /// Waits for the next refresh, and renders and presents a frame.
  LiveFrame next();

  /// Whether frames leave the processor to others from now on: they trace next to nothing, and not
  /// every refresh has one.
  void give_way(bool gives_way) { gives_way_ = gives_way; }

  /// What is known of the display's refreshes.
  const RefreshEstimator& refresh() const { return refresh_; }

  /// What is known of the time that frames take.
  const FrameBudget& budget() const { return budget_; }

  /// What a frame takes beside its tracing, while that is too long for frames ever to be in time.
  std::optional<Nanoseconds> too_slow_drawing() const;

 private:
  void trace(LiveFrame& frame);
  void trace_batch(std::uint64_t samples, LiveFrame& frame);
  void show(LiveFrame& frame);
  void note_shown_at(Nanoseconds refresh, LiveFrame& frame) const;
  /// The refresh that shows a frame which was ready at `end`, if none is known but by the clock;
  /// `end` itself where drawing is too slow for frames to keep the clock's time.
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

/// Whether the frame follows the eye, so that it has a latency: its gaze is the tracker's newest
/// sample, and valid. Others hold the gaze through a blink, or because the gaze is frozen.
bool follows_eye(const FrameReport& report);

/// The latency of a frame that follows the eye, by this tracker and on this display. Each stage
/// takes what it took; only the exposure has a best and a worst case. Their sum is the age of the
/// gaze, which is measured, and the time from its use until the frame was lit.
///
/// - exposure, transfer, processing, scan-out: as the profiles say;
/// - waiting for the frame: what is left of the gaze's age, measured;
/// - tracing: measured, with polling, aiming, and numbering and adding up samples in the film;
/// - film and resample: the display's image, measured;
/// - present: until the refresh that shows the frame, as well known as that is.
LatencyStages frame_latency(const LiveFrame& frame, const TrackerProfile& tracker,
                            const DisplayProfile& display);

/// No gaze should be older when it is used: from the middle of its exposure an image takes the rest
/// of that, transfer and processing to become known, and is then the newest for a period of the
/// tracker.
double gaze_age_limit_s(const TrackerProfile& tracker);

}  // namespace foveola
