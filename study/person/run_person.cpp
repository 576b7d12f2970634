#include "study/person/run_person.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/headset/live_display.h"
#include "renderer/headset/live_window.h"
#include "study/console/console_words.h"
#include "study/console/screen_console.h"
#include "study/console/terminal.h"
#include "study/driver/session_so_far.h"
#include "study/person/changed_setup.h"
#include "study/person/devices/session_window.h"
#include "study/person/forms/missing_letters.h"
#include "study/person/forms/words.h"
#include "study/person/preflight_measurement.h"
#include "study/person/run_equipment.h"
#include "study/person/session/person_session.h"
#include "study/person/session_copies.h"
#include "study/person/session_start.h"
#include "study/preflight/preflight_checks.h"
#include "study/preflight/system_state.h"
#include "study/record/setup/same_scenes.h"
#include "study/record/setup/session_devices.h"
#include "study/record/setup/session_programs.h"
#include "study/record/write/clock_steps.h"
#include "study/record/write/recorders.h"
#include "study/stage/stage_reload.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

SessionState resumed_state(SessionState state) {
  if (state.phase == Phase::interrupted || state.phase == Phase::paused || state.is_over()) {
    state.phase = state.resumes_at;
  }
  return state;
}

/// The session is valid without its pictures, and continues to its backup.
void say_if_pictures_are_lost(SessionDisplay& display, Console& console) {
  try {
    display.finish_pictures();
  } catch (const Error& error) {
    console.say(fmt::format("Some pictures of pages are missing: {}", error.what()));
  }
}

/// One session, in a thread beside the window's.
class PersonRun {
 public:
  PersonRun(const RunSettings& settings, const Protocol& protocol,
            const SceneFinderBeside& find_scene, const std::vector<SceneSource>& sources,
            DisplayProfile profile, const FoundDisplay& found_display, TrackerProfile tracker,
            StudyStore& store, LineWriter& output, std::optional<SessionSoFar> so_far)
      : settings_(settings),
        protocol_(protocol),
        find_scene_(find_scene),
        sources_(sources),
        profile_(std::move(profile)),
        found_display_(found_display),
        tracker_(std::move(tracker)),
        store_(store),
        output_(output),
        console_(open_output(settings.json, output)),
        so_far_(std::move(so_far)) {}

  Phase run(Window& window, WindowEvents& events, const IVec2& framebuffer, const Clock& clock,
            const std::stop_token& stop) {
    const Workers workers(settings_.threads);
    DisplayProfile profile = profile_;
    profile.refresh_rate_hz = found_display_.refresh_rate_hz;
    LiveDisplay shown_on(window, events, profile, framebuffer, clock);
    if (shown_on.headset() != nullptr) {
      profile_ = shown_on.profile();
      found_display_.refresh_rate_hz = profile_.refresh_rate_hz;
      worn_.emplace(shown_on.headset()->motion());
      protocol_.texts = texts_in_headset(std::move(protocol_.texts));
    }
    SessionDisplay display(shown_on.presenter(), shown_on.profile(), shown_on.picture_px(), clock);
    display.show({.screen = notice_screen(Notice::loading, protocol_.texts)});
    const SceneStages stages =
        load_beside(events, stop, [&] { return load_stages(protocol_, sources_, workers); });
    check(stages);
    const WindowEyeTracker gaze = open_eye_tracker_of(shown_on, tracker_, clock);
    measure_refreshes(display, protocol_.texts, stop);
    const std::string devices =
        devices_json(display, shown_on.headset(), window.key_time_source(), workers.threads(),
                     preflight(stages, workers, clock, events, display, gaze, stop));
    compare_setup(devices);
    say_if_keys_are_late(window.key_time_source(), *console_);
    say_if_code_is_alike(settings_.participant, store_, *console_);
    if (!settings_.json && Terminal::is_there()) {
      wait_for_confirmation(display, protocol_.texts, *console_, stop);
    }
    const PersonSessionSettings session = so_far_ ? going_on(devices) : beginning(stages, devices);
    ThreadedRecorder recorder(store_, row_);
    const std::unique_ptr<StageReloader> reloader = reloader_of(stages);
    std::unique_ptr<Console> console = open_console(settings_.json, output_);
    const SessionOutcome outcome = PersonSession(session,
                                                 {.protocol = protocol_,
                                                  .plan = plan_,
                                                  .stages = stages,
                                                  .workers = workers,
                                                  .reloader = reloader.get()},
                                                 {.clock = clock,
                                                  .events = events,
                                                  .display = display,
                                                  .tracker = *gaze.tracker,
                                                  .pointer = gaze.pointer,
                                                  .head = head(),
                                                  .has_focus = worn_ || window.has_focus()},
                                                 *console, recorder)
                                       .run(stop);
    console.reset();  // Later lines are printed below the console's.
    say_if_pictures_are_lost(display, *console_);
    return outcome.phase;
  }

  /// Whether the record has the session.
  bool has_begun() const { return row_ != 0; }

  bool is_blind() const {
    return settings_.is_blind || (so_far_ && is_experimenter_blind(so_far_->session.devices));
  }

 private:
  /// Reports the findings. Throws Error if the protocol demands more; rehearsals continue
  /// regardless.
  nlohmann::ordered_json preflight(const SceneStages& stages, const Workers& workers,
                                   const Clock& clock, WindowEvents& events,
                                   SessionDisplay& display, const WindowEyeTracker& gaze,
                                   const std::stop_token& stop) {
    PersonTracker eye(*gaze.tracker);
    Viewer viewer(gaze.pointer, head());
    viewer.show(display.geometry(), display.framebuffer(), 1.0);
    const MeasuredTrials measured = measure_trials({.protocol = protocol_,
                                                    .stages = stages,
                                                    .workers = workers,
                                                    .clock = clock,
                                                    .events = events,
                                                    .display = display,
                                                    .eye = eye,
                                                    .viewer = viewer},
                                                   stop);
    const Preflight found{
        .speeds = measured.speeds,
        .tracker = tracker_,
        .gaze = measured.gaze,
        .display = profile_,
        .found_display = as_measured(found_display_, display),
        .view_deg = {display.geometry().horizontal_fov_deg, display.geometry().vertical_fov_deg},
        .film_px = smallest_film(protocol_),
        .free_bytes = free_bytes_for(settings_.database),
        .is_clock_set = is_clock_synchronised()};
    const std::vector<PreflightCheck> checks = check_preflight(found, protocol_.preflight);
    console_->say(preflight_table(checks));
    console_->say(preflight_banner(found, settings_.kind == SessionKind::pilot));
    if (settings_.kind == SessionKind::human) {
      require_gate(checks);
    }
    return preflight_json(found, checks);
  }

  /// A new rehearsal is not compared.
  void compare_setup(const std::string& devices) {
    if (settings_.kind != SessionKind::human && !so_far_) {
      return;
    }
    const SetupChanges changes = setup_changes(read_session_setups(settings_.database),
                                               settings_.participant, devices, protocol_.preflight);
    if (!settings_.accept_changes) {
      require_same_setup(changes, settings_.participant);
    }
    for (const auto* found : {&changes.demanded, &changes.others}) {
      for (const std::string& change : *found) {
        console_->say(fmt::format("WARNING: other equipment: {}.", change));
      }
    }
    if (!changes.demanded.empty()) {
      accepted_changes_.push_back(note_of_changes(changes.demanded));
    }
  }

  /// Null: keys turn the head.
  HeadTracker* head() { return worn_ ? &*worn_ : nullptr; }

  std::string devices_json(const SessionDisplay& display, const HeadsetPresenter* headset,
                           KeyTimeSource key_times, int threads,
                           const nlohmann::ordered_json& preflight) const {
    nlohmann::ordered_json json = {
        {"display", display_json(display, profile_)},
        {"tracker", tracker_json(tracker_.name, protocol_.tracker.filter)},
        {"keys", {{"time_source", name_of(key_times)}}},
        {"machine", machine_json(threads)},
        {"preflight", preflight}};
    if (is_blind()) {
      json["experimenter_is_blind"] = true;
    }
    if (headset != nullptr) {
      json["headset"] = headset_json(headset->facts());
    }
    return with_renderer(json.dump(), build_info());
  }

  void check(const SceneStages& stages) {
    print_scene_warnings(stages);
    try {
      require_same_scenes(settings_.database, shown_scenes(stages));
    } catch (const Error& change) {
      if (!settings_.accept_changes) {
        throw;
      }
      accepted_changes_.push_back(note_of_changes({change.what()}));
    }
  }

  /// Null except in rehearsals.
  std::unique_ptr<StageReloader> reloader_of(const SceneStages& stages) const {
    if (settings_.kind != SessionKind::pilot) {
      return nullptr;
    }
    const auto find = [this](const std::string& scene) {
      const auto entry = std::find_if(protocol_.scenes.begin(), protocol_.scenes.end(),
                                      [&](const SceneEntry& one) { return one.name == scene; });
      return find_scene_of(protocol_, *entry, find_scene_);
    };
    try {
      return std::make_unique<StageReloader>(stages, find, settings_.threads);
    } catch (const Error& refusal) {
      console_->say(fmt::format("Scenes will not be reloaded: {}", refusal.what()));
      return nullptr;
    }
  }

  PersonSessionSettings beginning(const SceneStages& stages, const std::string& devices) {
    SessionFacts facts{.participant = settings_.participant,
                       .kind = settings_.kind,
                       .seed = settings_.seed ? *settings_.seed : draw_seed(),
                       .design_row = next_design_row(protocol_, store_, settings_.first_row),
                       .build = build_info(),
                       .machine = machine_info(),
                       .devices = devices,
                       .scenes = shown_scenes(stages)};
    plan_ = make_plan(protocol_, facts.seed, facts.design_row);
    const std::string order =
        is_blind() ? ""
                   : fmt::format(" row {} of the design, seed {},", facts.design_row, facts.seed);
    console_->say(
        fmt::format("Participant {},{} {} trials.", facts.participant, order, plan_.size()));
    row_ = store_.begin_session(facts, plan_);
    return settings_of({.seed = facts.seed, .design_row = facts.design_row}, {},
                       notes_of_eye(tracker_));
  }

  PersonSessionSettings going_on(const std::string& devices) {
    plan_ = so_far_->plan;
    const KnownSession& known = so_far_->session;
    const Procedure procedure = procedure_of(protocol_, plan_);
    const SessionState state = resumed_state(so_far_->position.state);
    console_->say(fmt::format("Participant {} resumes after {:.0f} s.", known.participant,
                              seconds(so_far_->position.time)));
    const Plan told = is_blind() ? without_methods(plan_) : plan_;
    console_->say(fmt::format("Next: {}; then {}.", words_for(state, procedure, told),
                              words_for_next(state, procedure, told)));
    row_ = known.id;
    std::vector<std::string> notes = notes_of_eye(tracker_);
    notes.push_back(note_of_devices(devices));
    if (const std::string program = program_name(build_info()); program != so_far_->program) {
      notes.push_back(note_of_program(program, so_far_->program));
    }
    if (std::optional<std::string> note = note_of_clock(store_.events_of(row_), utc_now())) {
      notes.push_back(std::move(*note));
    }
    return settings_of({.seed = known.seed, .design_row = known.design_row}, so_far_->position,
                       std::move(notes));
  }

  PersonSessionSettings settings_of(const SessionSeed& seed, const SessionPosition& position,
                                    std::vector<std::string> notes) const {
    if (store_.amendment()) {
      notes.push_back(note_of(*store_.amendment()));
    }
    notes.insert(notes.end(), accepted_changes_.begin(), accepted_changes_.end());
    return {.participant = settings_.participant,
            .eye = eye_of(tracker_.source),
            .seed = seed,
            .position = position,
            .notes = std::move(notes),
            .is_experimenter_blind = is_blind(),
            .screens = settings_.screens};
  }

  const RunSettings& settings_;
  Protocol protocol_;  ///< with the texts that are shown
  const SceneFinderBeside& find_scene_;
  const std::vector<SceneSource>& sources_;
  DisplayProfile profile_;
  FoundDisplay found_display_;
  std::optional<HeadsetHead> worn_;
  TrackerProfile tracker_;
  StudyStore& store_;
  LineWriter& output_;
  std::unique_ptr<Console> console_;  ///< before and after the session
  std::optional<SessionSoFar> so_far_;
  Plan plan_;
  std::int64_t row_ = 0;  ///< the session's row in the store
  std::vector<std::string>
      accepted_changes_;  ///< notes of accepted changes to scenes and equipment
};

/// Everything acknowledged to the participant is durable.
std::string remedy_by_resuming(const RunSettings& settings, const StudyStore& store) {
  const bool is_lost = store.record_file() != fs::weakly_canonical(settings.database);
  return is_lost ? fmt::format(
                       "what {} did up to then is in {}: repeat the command with that "
                       "file and --resume",
                       settings.participant, store.record_file().string())
                 : fmt::format("what {} did up to then is in {}: repeat the command with --resume",
                               settings.participant, settings.database.string());
}

}  // namespace

RunReport run_person(const RunSettings& settings, const SceneFinderBeside& find_scene,
                     const std::stop_token& stop) {
  const Protocol protocol = protocol_of(settings);
  warn_of_missing_letters(protocol);
  const std::vector<SceneSource> sources = find_scenes(protocol, find_scene);
  const DisplayProfile display = display_of(settings, protocol);
  const TrackerProfile tracker = tracker_of(settings, protocol);
  require_real_gaze(tracker, settings.kind);
  StudyStore store(settings.database, protocol, settings.other_protocol);
  std::optional<SessionSoFar> so_far = session_so_far(store, protocol, settings.participant,
                                                      {.kind = settings.kind,
                                                       .resumes = settings.resumes,
                                                       .accept_changes = settings.accept_changes,
                                                       .undo_end = settings.undo_end});
  print_notes(protocol.notes);
  silence_xr_loader();
  const SteadyClock clock;
  WindowEvents events;
  Window window({.size = settings.window,
                 .monitor = settings.monitor,
                 .display_lost_remedy = remedy_by_resuming(settings, store)},
                events, clock);
  std::fflush(stdout);
  LineWriter output(STDOUT_FILENO);
  PersonRun run(settings, protocol, find_scene, sources, display,
                found_display(window, settings.monitor, display), tracker, store, output,
                std::move(so_far));
  RunReport report;
  run_beside(window, stop, [&](const IVec2& framebuffer) {
    try {
      report.phase = run.run(window, events, framebuffer, clock, stop);
    } catch (const Error& fault) {
      if (!run.has_begun()) {
        throw;
      }
      throw Error(fmt::format("the session of {} was interrupted", settings.participant),
                  fault.what(), remedy_by_resuming(settings, store));
    }
    report.is_blind = run.is_blind();
    write_receipt(settings, store);
    report.copy = copy_if_asked(store, settings);
    report.backup = back_up(store, settings);
  });
  return report;
}

}  // namespace foveola::study
