// From a tracker's profile to the tracker.
#pragma once

#include <memory>

#include "renderer/base/clock.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/profiles.h"
#include "renderer/gaze/screen.h"

namespace foveola {

/// Begins to look for the tracker at once, and does not wait for it. screen: what it watches the
/// eyes look at. clock: that of samples, steady, must outlive the tracker. A simulated one watches
/// a simulated eye whose time begins now, as does a recording's. Throws Error if a host is unknown
/// or a recording bad.
std::unique_ptr<EyeTracker> open_eye_tracker(const TrackerProfile& profile, const Screen& screen,
                                             const Clock& clock);

}  // namespace foveola
