#include "renderer/gaze/gaze_source.h"

#include <utility>

#include "renderer/base/error.h"
#include "renderer/gaze/hid/hid_eye_tracker.h"
#include "renderer/gaze/open_gaze/open_gaze_tracker.h"
#include "renderer/gaze/recordings.h"
#include "renderer/gaze/simulated_eye.h"

namespace foveola {
namespace {

std::unique_ptr<EyeTracker> open_hid(const TrackerProfile& profile, const Screen& screen,
                                     const Clock& clock) {
  const HidTrackerSettings settings{
      .gaze = {.screen = screen, .latency_s = seconds(shortest_delay(profile))}};
  return std::make_unique<HidEyeTracker>([] { return open_hid_eye_tracker(); }, clock, settings);
}

std::unique_ptr<EyeTracker> open_open_gaze(const TrackerProfile& profile, const Screen& screen) {
  OpenGazeSettings settings{.address = profile.open_gaze, .screen = screen};
  settings.latency = shortest_delay(profile);
  return std::make_unique<OpenGazeTracker>(settings);
}

std::unique_ptr<EyeTracker> replay(const TrackerProfile& profile, const Clock& clock) {
  return std::make_unique<RecordedEyeTracker>(read_gaze_file(profile.recording), clock.now(),
                                              shortest_delay(profile));
}

std::unique_ptr<EyeTracker> watch_simulated_eye(const TrackerProfile& profile, const Clock& clock) {
  const auto eye = std::make_shared<SimulatedEye>(SimulatedEyeSettings{});
  const Nanoseconds start = clock.now();
  return std::make_unique<SimulatedEyeTracker>(
      profile.simulated, [eye, start](Nanoseconds time) { return eye->gaze(time - start); });
}

}  // namespace

std::unique_ptr<EyeTracker> open_eye_tracker(const TrackerProfile& profile, const Screen& screen,
                                             const Clock& clock) {
  switch (profile.source) {
    case TrackerSource::hid:
      return open_hid(profile, screen, clock);
    case TrackerSource::open_gaze:
      return open_open_gaze(profile, screen);
    case TrackerSource::openxr:
      throw Error("tracker '" + profile.name + "'",
                  "it is a part of the headset that OpenXR shows in",
                  "use it with --headset, or choose another tracker");
    case TrackerSource::pointer:
      throw Error("tracker '" + profile.name + "'", "there is no window to point in",
                  "use it where there is one, or choose another tracker");
    case TrackerSource::recorded:
      return replay(profile, clock);
    case TrackerSource::simulated:
      break;
  }
  return watch_simulated_eye(profile, clock);
}

WindowEyeTracker open_window_eye_tracker(const TrackerProfile& profile, const Screen& screen,
                                         const Clock& clock) {
  if (profile.source != TrackerSource::pointer) {
    return {.tracker = open_eye_tracker(profile, screen, clock)};
  }
  auto pointer = std::make_unique<PointerEyeTracker>();
  PointerEyeTracker* const moved = pointer.get();
  return {.tracker = std::move(pointer), .pointer = moved};
}

}  // namespace foveola
