// The latency from the eye's movement to the light of a certain frame.
#pragma once

#include "renderer/gaze/latency.h"
#include "renderer/gaze/profiles.h"
#include "renderer/preview/live_frames.h"

namespace foveola {

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
