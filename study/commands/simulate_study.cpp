#include "study/commands/simulate_study.h"

#include <utility>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/progress.h"
#include "study/commands/participant_code.h"
#include "study/commands/same_scenes.h"
#include "study/commands/session_runner.h"
#include "study/participant/simulated_participant.h"
#include "study/stage/scene_stage.h"
#include "study/stage/seeds.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// The first participant from `index` on who is not in the file yet: a study can be added to.
int new_participant(const StudyStore& store, int index) {
  while (store.has_participant(participant_code(index))) {
    ++index;
  }
  return index;
}

bool has_ended(const KnownSession& session) {
  return SessionState{.phase = session.phase}.is_over();
}

std::vector<KnownSession> simulated_sessions(const StudyStore& store) {
  std::vector<KnownSession> sessions = store.sessions();
  std::erase_if(sessions,
                [](const KnownSession& session) { return session.kind != SessionKind::simulated; });
  return sessions;
}

/// Throws Error unless this program with this seed can go on with `session`.
void require_resumable(const SimulateSettings& settings, const KnownSession& session) {
  const auto refused = [&](const std::string& what, const std::string& remedy) {
    return Error(
        settings.database.string(),
        fmt::format("the unfinished session of {} was begun with {}", session.participant, what),
        remedy);
  };
  if (session.seed != settings.seed) {
    throw refused(fmt::format("seed {}, not {}", session.seed, settings.seed),
                  fmt::format("finish it with --seed {}", session.seed));
  }
  const std::string version = build_info().version;
  if (session.program_version != version) {
    throw refused(fmt::format("Foveola {}, which is now {}", session.program_version, version),
                  "finish it with the program it was begun with");
  }
}

/// Refuses a bad database before minutes of work instead of after them.
void require_usable(const SimulateSettings& settings, const Protocol& protocol) {
  require_writable(settings.database);
  if (!fs::exists(settings.database)) {
    return;
  }
  const StudyStore checked(settings.database, protocol);
  if (settings.resume) {
    for (const KnownSession& session : simulated_sessions(checked)) {
      if (!has_ended(session)) {
        require_resumable(settings, session);
      }
    }
  }
}

/// Renders what each scene converges to, until it is stopped.
void render_references(const SceneStages& stages, const Protocol& protocol, const Workers& workers,
                       const std::stop_token& stop) {
  Progress progress("Reference images");
  double stages_done = 0.0;
  for (const auto& [name, stage] : stages) {
    const std::string& scene = name;
    const auto show = [&](double fraction) {
      progress.update((stages_done + fraction) / static_cast<double>(stages.size()), scene);
    };
    try {
      const TrialSettings baseline = settings_of(protocol, name, protocol.methods.front());
      stage->render_reference(baseline.film, protocol.reference, workers, show, stop);
    } catch (const Error&) {
      if (stop.stop_requested()) {
        return;
      }
      throw;
    }
    stages_done += 1.0;
  }
}

/// Runs the participants of one study.
class StudySimulation {
 public:
  StudySimulation(const SimulateSettings& settings, const Protocol& protocol,
                  const SceneStages& stages, std::vector<ShownScene> shown, const Workers& workers)
      : settings_(settings),
        protocol_(protocol),
        stages_(stages),
        shown_(std::move(shown)),
        workers_(workers),
        store_(settings.database, protocol) {}

  SimulateReport run(const std::stop_token& stop) {
    int done = settings_.resume ? finish_begun_sessions(stop) : 0;
    for (int index = 0; done < settings_.participants && !stop.stop_requested(); ++done) {
      index = new_participant(store_, index);
      const Plan plan = make_plan(protocol_, settings_.seed, index);
      run_session({.id = store_.begin_session(facts_of(index), plan), .design_row = index}, plan,
                  done, stop);
    }
    return report_;
  }

 private:
  struct BegunSession {
    std::int64_t id = 0;
    int design_row = 0;  ///< by which all of its seeds are made
  };

  /// Returns how many sessions there are of this seed.
  int finish_begun_sessions(const std::stop_token& stop) {
    int done = 0;
    for (const KnownSession& session : simulated_sessions(store_)) {
      if (session.seed != settings_.seed) {
        continue;  // of another run, and over
      }
      if (has_ended(session)) {
        ++report_.sessions_before;
      } else if (!stop.stop_requested()) {
        run_session({.id = session.id, .design_row = session.design_row},
                    store_.plan_of(session.id), done, stop);
      }
      ++done;
    }
    return done;
  }

  /// From its start, or from where it broke off.
  void run_session(const BegunSession& session, const Plan& plan, int done,
                   const std::stop_token& stop) {
    const SessionSeed seed{.seed = settings_.seed, .design_row = session.design_row};
    SimulatedParticipant participant(
        Population{}, [this](const std::string& scene) { return knowledge_of(scene); },
        derive_seed(seed, SeedPurpose::participant, {}));
    const SessionSetting setting{.protocol = protocol_,
                                 .stages = stages_,
                                 .store = store_,
                                 .workers = workers_,
                                 .seed = seed,
                                 .on_trial = [&](std::size_t trial) { show(done, trial, plan); },
                                 .stop = stop};
    SessionRunner runner(setting, plan, session.id, participant);
    runner.resume_after(store_.events_of(session.id));
    add(runner.run());
  }

  SessionFacts facts_of(int index) const {
    return {.participant = participant_code(index),
            .kind = SessionKind::simulated,
            .seed = settings_.seed,
            .design_row = index,
            .build = build_info(),
            .machine = machine_info(),
            .scenes = shown_};
  }

  void show(int sessions_done, std::size_t trial, const Plan& plan) {
    const double sessions =
        sessions_done + static_cast<double>(trial) / static_cast<double>(plan.size());
    progress_.update(sessions / settings_.participants,
                     fmt::format("participant {} of {}, {}", sessions_done + 1,
                                 settings_.participants, plan[trial].scene));
  }

  KnownScene knowledge_of(const std::string& scene) const {
    const SceneStage& stage = *stages_.at(scene);
    return {.panorama = &stage.reference(), .exposure_stops = stage.source().exposure_stops};
  }

  void add(const SessionOutcome& outcome) {
    report_.sessions_completed += outcome.phase == Phase::completed ? 1 : 0;
    report_.sessions_refused += outcome.phase == Phase::refused ? 1 : 0;
    report_.trials += static_cast<int>(outcome.trials);
    report_.simulated_s += seconds(outcome.duration);
    report_.samples += outcome.samples;
    report_.non_finite += outcome.non_finite;
  }

  const SimulateSettings& settings_;
  const Protocol& protocol_;
  const SceneStages& stages_;
  std::vector<ShownScene> shown_;
  const Workers& workers_;
  StudyStore store_;
  Progress progress_{"Simulating"};
  SimulateReport report_;
};

}  // namespace

SimulateReport simulate_study(const SimulateSettings& settings, const SceneFinder& find_scene,
                              std::stop_token stop) {
  if (settings.participants < 1) {
    throw UsageError("--participants", "must be at least 1");
  }
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  const Protocol protocol = load_protocol(settings.protocol);
  const std::vector<SceneSource> sources = find_scenes(protocol, find_scene);
  require_usable(settings, protocol);
  const Workers workers(settings.threads);
  const SceneStages stages = load_stages(protocol, sources, workers);
  const std::vector<ShownScene> shown = shown_scenes(stages);
  warn_of_other_files(stages);
  if (fs::exists(settings.database)) {
    require_same_scenes(settings.database, shown);
  }
  render_references(stages, protocol, workers, stop);
  SimulateReport report;
  if (!stop.stop_requested()) {
    report = StudySimulation(settings, protocol, stages, shown, workers).run(stop);
  }
  report.wall_s = seconds(clock.now() - start);
  return report;
}

}  // namespace foveola::study
