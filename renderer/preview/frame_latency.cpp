#include "renderer/preview/frame_latency.h"

#include <algorithm>
#include <span>

namespace foveola {
namespace {

KnownDuration measured(double duration_s) {
  return {.duration_s = std::max(0.0, duration_s), .provenance = Provenance::measured};
}

LatencyInputs inputs_of(const TrackerProfile& tracker) {
  return {.tracker_rate_hz = tracker.rate_hz,
          .exposure = tracker.exposure,
          .transfer = tracker.transfer,
          .processing = tracker.processing};
}

/// The time from the moment that a sample shows until it is here.
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
