#include "renderer/preview/live_frames.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace foveola {
namespace {

/// Maximum number of batches per frame. The third fills the rest of the second, a sixteenth of the
/// time or less if costs vary by a tenth; a fourth would gain a hundredth.
constexpr int max_batches = 3;

KnownDuration measured(double duration_s) {
  return {.duration_s = std::max(0.0, duration_s), .provenance = Provenance::measured};
}

LatencyInputs inputs_of(const TrackerProfile& tracker) {
  return {.tracker_rate_hz = tracker.rate_hz,
          .exposure = tracker.exposure,
          .transfer = tracker.transfer,
          .processing = tracker.processing};
}

/// The delay of a sample from its time to its arrival.
double delay_s(const TrackerProfile& tracker) {
  constexpr std::size_t tracker_stages = 3;
  const LatencyStages stages = latency_stages(inputs_of(tracker));
  return total_latency(std::span(stages).first(tracker_stages)).best_s;
}

KnownDuration present_time(const LiveFrame& frame) {
  const Nanoseconds resampled = frame.start + frame.polling + frame.tracing + frame.resampling;
  KnownDuration present = measured(seconds(frame.shown - resampled));
  if (!frame.is_refresh_measured) {
    present.provenance = Provenance::assumed;
  }
  return present;
}

}  // namespace

LiveFrames::LiveFrames(Preview& preview, const Clock& clock, const RefreshEstimator& refresh,
                       WaitUntil wait_until, FrameOutput output, const FrameBudget& budget)
    : preview_(&preview),
      clock_(&clock),
      refresh_(refresh),
      wait_until_(std::move(wait_until)),
      output_(std::move(output)),
      next_refresh_(clock.now()),
      budget_(budget) {}

LiveFrame LiveFrames::next() {
  wait_until_(next_refresh_);
  LiveFrame frame{.start = clock_->now(), .deadline = next_refresh_ + refresh_.interval()};
  frame.report = preview_->begin_frame(frame.start);
  frame.polling = clock_->now() - frame.start;
  trace(frame);
  show(frame);
  budget_.frame_ended(frame.is_late());
  // A nearly constant picture is drawn rarely.
  constexpr int refreshes_skipped = 2;
  next_refresh_ = frame.shown + (gives_way_ ? refreshes_skipped : 0) * refresh_.interval();
  return frame;
}

std::optional<Nanoseconds> LiveFrames::too_slow_drawing() const {
  return budget_.is_drawing_too_slow() ? std::optional(budget_.drawing_time()) : std::nullopt;
}

void LiveFrames::trace(LiveFrame& frame) {
  if (gives_way_) {
    constexpr std::uint64_t hardly_any = 64;
    preview_->trace(hardly_any, frame.report);
    return;
  }
  const Nanoseconds start = clock_->now();
  const Nanoseconds end = start + budget_.begin_frame(frame.deadline - start, refresh_.interval());
  const auto left = [&] { return end - clock_->now(); };
  std::uint64_t samples = budget_.first_batch(left());
  for (int batch = 0; batch < max_batches && samples > 0; ++batch) {
    trace_batch(samples, frame);
    samples = budget_.next_batch(left());
  }
}

void LiveFrames::trace_batch(std::uint64_t samples, LiveFrame& frame) {
  const Nanoseconds start = clock_->now();
  preview_->trace(samples, frame.report);
  const Nanoseconds took = clock_->now() - start;
  budget_.batch_took(samples, took);
  frame.tracing += took;
}

void LiveFrames::show(LiveFrame& frame) {
  const Nanoseconds traced = clock_->now();
  output_.resample(*preview_);
  const Nanoseconds resampled = clock_->now();
  const std::optional<Nanoseconds> swapped = output_.present();
  const Nanoseconds end = clock_->now();
  frame.resampling = resampled - traced;
  frame.presenting = end - resampled;
  if (swapped) {
    refresh_.swap_completed(*swapped);
  }
  const bool waited = swapped && !refresh_.is_unsynchronised();
  frame.is_refresh_measured = waited && refresh_.is_measured();
  if (waited) {
    budget_.rest_took(frame.resampling);
    // No frame is shown before its refresh: the output may not have waited, after all.
    note_shown_at(refresh_.nearest_refresh(std::max(*swapped, frame.deadline)), frame);
  } else {
    budget_.rest_took(frame.resampling + frame.presenting);
    note_shown_at(assumed_refresh(frame, end), frame);
  }
}

void LiveFrames::note_shown_at(Nanoseconds refresh, LiveFrame& frame) const {
  const double missed = seconds(refresh - frame.deadline) * refresh_.rate_hz();
  frame.shown = refresh;
  frame.missed_refreshes = static_cast<std::uint64_t>(std::max(0.0, std::round(missed)));
}

Nanoseconds LiveFrames::assumed_refresh(const LiveFrame& frame, Nanoseconds end) const {
  if (budget_.is_drawing_too_slow()) {
    return std::max(end, frame.deadline);  // waiting would leave the processor idle
  }
  Nanoseconds refresh = frame.deadline;
  while (refresh < end) {
    refresh += refresh_.interval();
  }
  return refresh;
}

bool follows_eye(const FrameReport& report) { return report.gaze_valid && !report.gaze_held; }

LatencyStages frame_latency(const LiveFrame& frame, const TrackerProfile& tracker,
                            const DisplayProfile& display) {
  LatencyInputs inputs = inputs_of(tracker);
  inputs.waiting = measured(seconds(frame.report.gaze_age) - delay_s(tracker));
  inputs.tracing = measured(seconds(frame.polling + frame.tracing));
  inputs.film_and_resample = measured(seconds(frame.resampling));
  inputs.present = present_time(frame);
  inputs.scan_out = display.scan_out;
  return latency_stages(inputs);
}

double gaze_age_limit_s(const TrackerProfile& tracker) {
  return 1.0 / tracker.rate_hz + seconds(shortest_delay(tracker));
}

}  // namespace foveola
