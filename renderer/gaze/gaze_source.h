// Opens the tracker that a profile describes.
#pragma once

#include <memory>

#include "renderer/base/clock.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/profiles.h"

namespace foveola {

/// Begins to connect to the tracker at once, without waiting. screen: the screen that the tracker
/// observes. clock: of the samples, steady, must outlive the tracker. A simulated eye's time, and a
/// recording's, begins now. Throws Error for an unknown host or a bad recording, or if the tracker
/// is a window's pointer.
std::unique_ptr<EyeTracker> open_eye_tracker(const TrackerProfile& profile, const Screen& screen,
                                             const Clock& clock);

/// The tracker of a person in front of a window.
struct WindowEyeTracker {
  std::unique_ptr<EyeTracker> tracker;
  PointerEyeTracker* pointer = nullptr;  ///< the tracker, if the window has to move its pointer
};

/// As open_eye_tracker(), but also opens the window's pointer.
WindowEyeTracker open_window_eye_tracker(const TrackerProfile& profile, const Screen& screen,
                                         const Clock& clock);

}  // namespace foveola
