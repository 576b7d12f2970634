// Measures the speed and latency of a session's trials, with its own window and tracker.
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

/// Inputs of the measurement; all must outlive it.
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

/// Renders every scene with every method, for 8 s in all but at least 0.4 s each. A page covers the
/// picture, which stays black: nobody may see a method before its trial. The trials use the drawing
/// times that the display learns here. Throws Error if stopped.
MeasuredTrials measure_trials(const PreflightSubject& subject, const std::stop_token& stop);

/// Describes the window's monitor as far as the system knows it; size and rate are not measured
/// yet. full_screen_on: the monitor that the window fills. Call it in the window's own thread.
FoundDisplay found_display(const Window& window, const std::optional<int>& full_screen_on,
                           const DisplayProfile& stated);

/// Returns `found` with the values that the session's display has measured.
FoundDisplay as_measured(FoundDisplay found, const SessionDisplay& display);

}  // namespace foveola::study
