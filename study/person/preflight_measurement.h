// Measures, in the window and with the tracker of a session, what its trials will have.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/window/window.h"
#include "renderer/window/window_event.h"
#include "study/person/devices/person_tracker.h"
#include "study/person/devices/session_display.h"
#include "study/person/devices/viewer.h"
#include "study/preflight/preflight.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// What is measured; all of it must outlive the measurement.
struct PreflightSubject {
  const Protocol& protocol;
  const SceneStages& stages;
  const Workers& workers;
  const Clock& clock;
  WindowEvents& events;
  SessionDisplay& display;
  PersonTracker& eye;
  Viewer& viewer;
};

struct MeasuredTrials {
  std::vector<TrialSpeed> speeds;  ///< in the protocol's order of scenes and methods
  LiveGaze gaze;
};

/// Renders every scene with every method for a moment, under a page and in the dark, since nobody
/// may see a method before its trial: 8 seconds in all, but 0.4 for each at least. What the display
/// learns of drawing, trials then know. Throws Error if stopped.
MeasuredTrials measure_trials(const PreflightSubject& subject, const std::stop_token& stop);

/// The monitor that the window is on, as far as the system describes it; its size and rate are not
/// measured yet. full_screen_on: the monitor that it fills. To be asked in the window's own thread.
FoundDisplay found_display(const Window& window, const std::optional<int>& full_screen_on,
                           const DisplayProfile& stated);

/// The same with what the session's display has measured.
FoundDisplay as_measured(FoundDisplay found, const SessionDisplay& display);

}  // namespace foveola::study
