#include "study/simulation/real_time_study.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "renderer/headset/live_window.h"
#include "renderer/window/drawing/presenter.h"
#include "study/driver/session_so_far.h"
#include "study/person/devices/session_window.h"
#include "study/person/session/person_session.h"
#include "study/record/setup/session_devices.h"
#include "study/record/write/recorders.h"

namespace foveola::study {
namespace {

/// Returns the side of a pane at a distance of 1.
double side_m(double fov_deg) { return 2.0 * std::tan(0.5 * radians(fov_deg)); }

std::string devices_in_real_time(const SimulationKind& kind, const SessionDisplay& display,
                                 const DisplayProfile& profile, const GazeFilterSettings& filter) {
  nlohmann::ordered_json devices = nlohmann::ordered_json::parse(devices_of(kind));
  devices["display"] = display_json(display, profile);
  devices["tracker"] = tracker_json("simulated", filter);
  devices["keys"] = {{"time_source", "simulated"}};
  return devices.dump();
}

KnownSession session_in(const StudyStore& store, std::int64_t id) {
  const std::vector<KnownSession> sessions = store.sessions();
  return *std::ranges::find(sessions, id, &KnownSession::id);
}

struct SharedWindow {
  const SimulatedStudy& study;
  const Clock& clock;
  WindowEvents& window;
  SessionDisplay& display;
};

/// Returns the protocol's tracker, watching the simulated person.
SimulatedEyeTracker tracker_of(const SimulatedTrackerSettings& settings, std::uint32_t seed,
                               SimulatedOperator& simulated_operator) {
  SimulatedTrackerSettings seeded = settings;
  seeded.seed = seed;
  return SimulatedEyeTracker(seeded, [&simulated_operator](Nanoseconds time) {
    return std::optional<Vec3>(simulated_operator.gaze_in_head(time));
  });
}

SessionOutcome run_in_window(const SharedWindow& shared, const BegunSession& begun,
                             const std::stop_token& stop) {
  const Protocol& protocol = shared.study.protocol;
  const SessionSoFar so_far = so_far_of(begun.store, protocol, session_in(begun.store, begun.id));
  const SessionSeed seed{.seed = so_far.session.seed, .design_row = so_far.session.design_row};
  SimulatedOperator simulated_operator({.participant = begun.observer,
                                        .protocol = protocol,
                                        .plan = begun.plan,
                                        .seed = seed,
                                        .clock = shared.clock,
                                        .window = shared.window});
  SimulatedEyeTracker tracker = tracker_of(
      protocol.tracker.simulated, derive_seed(seed, SeedPurpose::tracker, {}), simulated_operator);
  SimulatedHeadTracker head([&](Nanoseconds time) { return simulated_operator.heading(time); });
  ThreadedRecorder recorder(begun.store, begun.id);
  const std::vector<std::string> notes =
      so_far.position.state.phase == Phase::created
          ? std::vector<std::string>{}
          : std::vector<std::string>{note_of_devices(shared.study.devices)};
  SilentConsole unwatched;
  return PersonSession({.seed = seed, .position = so_far.position, .notes = notes},
                       {.protocol = protocol,
                        .plan = begun.plan,
                        .stages = shared.study.stages,
                        .workers = shared.study.workers},
                       {.clock = shared.clock,
                        .events = simulated_operator.events(),
                        .display = shared.display,
                        .tracker = tracker,
                        .head = &head,
                        .simulated_operator = &simulated_operator},
                       unwatched, recorder)
      .run(stop);
}

}  // namespace

DisplayProfile shown_display(const Protocol& protocol) {
  const DisplaySettings& settings = protocol.display;
  DisplayProfile display = settings.profile.value_or(
      DisplayProfile{.name = "the protocol's", .refresh_rate_hz = protocol.machine.frame_rate_hz});
  display.width_px = settings.view_width;
  display.height_px = settings.view_height;
  if (display.kind == DisplayKind::headset) {
    display.width_px *= 2;
    display.horizontal_fov_deg = settings.horizontal_fov_deg;
    display.vertical_fov_deg = settings.vertical_fov_deg;
    display.lens = settings.lens;
  } else {
    display.viewing_distance_m = 1.0;
    display.width_m = side_m(settings.horizontal_fov_deg);
    display.height_m = side_m(settings.vertical_fov_deg);
  }
  return display;
}

SimulateReport run_in_real_time(SimulatedStudy& study, const SimulationKind& kind,
                                const std::stop_token& stop) {
  const SteadyClock clock;
  WindowEvents events;
  DisplayProfile profile = shown_display(study.protocol);
  Window window({.size = {profile.width_px, profile.height_px}}, events, clock);
  profile.refresh_rate_hz = said_refresh_rate_hz(window, 0, profile);
  SimulateReport report;
  run_beside(window, stop, [&](const IVec2& framebuffer) {
    WindowPresenter presenter(window, framebuffer, clock);
    SessionDisplay display(presenter, profile, framebuffer, clock);
    measure_refreshes(display, study.protocol.texts, stop);
    study.devices = devices_in_real_time(kind, display, profile, study.protocol.tracker.filter);
    study.run_in_window = [shared = SharedWindow{study, clock, events, display}](
                              const BegunSession& session, const std::stop_token& stopped) {
      return run_in_window(shared, session, stopped);
    };
    report = StudySimulation(study).run(stop);
  });
  return report;
}

}  // namespace foveola::study
