#include "study/commands/real_time_study.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "renderer/commands/live_window.h"
#include "study/commands/session_so_far.h"
#include "study/commands/session_window.h"
#include "study/person/person_session.h"
#include "study/record/threaded_recorder.h"

namespace foveola::study {
namespace {

constexpr int no_input = -1;

/// The side of a pane at a distance of 1.
double side_m(double fov_deg) { return 2.0 * std::tan(0.5 * radians(fov_deg)); }

std::string devices_in_real_time(const SimulationKind& kind, const SessionDisplay& display,
                                 const DisplayProfile& profile) {
  nlohmann::ordered_json devices = nlohmann::ordered_json::parse(devices_of(kind));
  devices["display"] = display_json(display, profile);
  devices["tracker"] = {{"profile", "simulated"}};
  devices["keys"] = {{"time_source", "simulated"}};
  return devices.dump();
}

KnownSession session_in(const StudyStore& store, std::int64_t id) {
  const std::vector<KnownSession> sessions = store.sessions();
  return *std::find_if(sessions.begin(), sessions.end(),
                       [&](const KnownSession& session) { return session.id == id; });
}

std::size_t trials_rated(const StudyStore& store, std::int64_t session) {
  const std::vector<LoggedEvent> events = store.events_of(session);
  return static_cast<std::size_t>(std::count_if(
      events.begin(), events.end(),
      [](const LoggedEvent& logged) { return std::holds_alternative<Rated>(logged.event); }));
}

/// What the sessions of a study share.
struct Seat {
  const SimulatedStudy& study;
  const Clock& clock;
  WindowEvents& window;
  SessionDisplay& display;
};

/// The protocol's tracker, watching whoever sits there.
SimulatedEyeTracker tracker_of(const SimulatedTrackerSettings& settings, std::uint32_t seed,
                               SimulatedOperator& simulated_operator) {
  SimulatedTrackerSettings seeded = settings;
  seeded.seed = seed;
  return SimulatedEyeTracker(seeded, [&simulated_operator](Nanoseconds time) {
    return std::optional<Vec3>(simulated_operator.gaze_in_head(time));
  });
}

SessionOutcome sit(const Seat& seat, const BegunSession& begun, const std::stop_token& stop) {
  const Protocol& protocol = seat.study.protocol;
  const SessionSoFar so_far = so_far_of(begun.store, protocol, session_in(begun.store, begun.id));
  const SessionSeed seed{.seed = so_far.session.seed, .design_row = so_far.session.design_row};
  SimulatedOperator simulated_operator({.participant = &begun.observer,
                                        .protocol = &protocol,
                                        .plan = &begun.plan,
                                        .seed = seed,
                                        .clock = &seat.clock,
                                        .window = &seat.window});
  SimulatedEyeTracker tracker = tracker_of(
      protocol.tracker.simulated, derive_seed(seed, SeedPurpose::tracker, {}), simulated_operator);
  PersonTracker eye(tracker);
  SimulatedHeadTracker head([&](Nanoseconds time) { return simulated_operator.heading(time); });
  ConsoleLines console(no_input);
  const std::size_t rated_before = trials_rated(begun.store, begun.id);
  SessionOutcome outcome;
  const Nanoseconds start = seat.clock.now();
  {
    ThreadedRecorder recorder(begun.store, begun.id);
    PersonSession session({.seed = seed,
                           .state = so_far.state,
                           .time = so_far.time,
                           .correction = so_far.correction,
                           .devices = seat.study.devices},
                          {.protocol = &protocol,
                           .plan = &begun.plan,
                           .stages = &seat.study.stages,
                           .workers = &seat.study.workers,
                           .clock = &seat.clock,
                           .events = &simulated_operator.events(),
                           .display = &seat.display,
                           .eye = &eye,
                           .pointer = nullptr,
                           .head = &head,
                           .simulated_operator = &simulated_operator,
                           .recorder = &recorder,
                           .console = &console,
                           .tell = [](const std::string& /*line*/) {}});
    outcome.phase = session.run(stop);
    outcome.samples = session.samples();
    outcome.non_finite = session.non_finite();
  }
  outcome.duration = seat.clock.now() - start;
  outcome.trials = trials_rated(begun.store, begun.id) - rated_before;
  return outcome;
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
    SessionDisplay display(window, profile, framebuffer, clock);
    measure_refreshes(display, study.protocol.texts);
    study.devices = devices_in_real_time(kind, display, profile);
    study.sit = [seat = Seat{study, clock, events, display}](const BegunSession& session,
                                                             const std::stop_token& stopped) {
      return sit(seat, session, stopped);
    };
    report = StudySimulation(study).run(stop);
  });
  return report;
}

}  // namespace foveola::study
