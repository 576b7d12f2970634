// Opens the tracker that a profile describes.
#pragma once

#include <memory>

#include "renderer/base/clock.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/profiles.h"

namespace foveola {

/// Begins to look for the tracker at once, and does not wait for it. screen: what it watches the
/// eyes look at. clock: that of samples, steady, must outlive the tracker. A simulated one watches
/// a simulated eye whose time begins now, as does a recording's. Throws Error if a host is unknown,
/// a recording bad, or the tracker a window's pointer.
std::unique_ptr<EyeTracker> open_eye_tracker(const TrackerProfile& profile, const Screen& screen,
                                             const Clock& clock);

/// The tracker of the person who looks into a window.
struct WindowEyeTracker {
  std::unique_ptr<EyeTracker> tracker;
  PointerEyeTracker* pointer = nullptr;  ///< the tracker, if the window is to move its pointer
};

/// As open_eye_tracker(), but opens the window's pointer too.
WindowEyeTracker open_window_eye_tracker(const TrackerProfile& profile, const Screen& screen,
                                         const Clock& clock);

}  // namespace foveola
