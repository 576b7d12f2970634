#include "study/simulation/simulate_study.h"

#include <utility>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/work/work_scope.h"
#include "study/record/setup/same_scenes.h"
#include "study/record/setup/session_programs.h"
#include "study/record/setup/simulation_kind.h"
#include "study/simulation/predicted_study.h"
#include "study/simulation/real_time_study.h"
#include "study/simulation/rendered_attempt.h"
#include "study/simulation/simulation_setup.h"
#include "study/simulation/study_simulation.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

std::vector<KnownSession> simulated_sessions(const StudyStore& store) {
  std::vector<KnownSession> sessions = store.sessions();
  std::erase_if(sessions,
                [](const KnownSession& session) { return session.kind != SessionKind::simulated; });
  return sessions;
}

/// Throws Error unless this program, with this seed, can resume or accompany `session`.
void require_resumable(const SimulateSettings& settings, const KnownSession& session) {
  const auto refused = [&](const std::string& what, const std::string& remedy) {
    return Error(settings.database.string(),
                 fmt::format("the {}session of {} was begun with {}",
                             has_ended(session) ? "" : "unfinished ", session.participant, what),
                 remedy);
  };
  if (session.seed != settings.seed) {
    throw refused(fmt::format("seed {}, not {}", session.seed, settings.seed),
                  fmt::format("finish it with --seed {}", session.seed));
  }
  const std::string remedy = fmt::format(
      "finish it with that program, or erase it (foveola study forget) and simulate "
      "{} again",
      session.participant);
  const auto require_equal = [&](const std::string& then, const std::string& now) {
    if (then != now) {
      throw refused(fmt::format("{}, but this is {}", then, now), remedy);
    }
  };
  const BuildInfo now = build_info();
  require_equal(program_name(session.build), program_name(now));
  if (!session.build.instruction_set.empty()) {  // older programs did not record it
    require_equal(exact_name(session.build), exact_name(now));
  }
}

/// Refuses a bad database before minutes of work.
void require_usable(const SimulateSettings& settings, const Protocol& protocol,
                    const SimulationKind& kind) {
  require_writable(settings.database);
  if (!fs::exists(settings.database)) {
    return;
  }
  if (settings.shard && !settings.resume) {
    throw Error(settings.database.string(), "exists already, but a shard needs a file of its own",
                "name a new file, or resume this one with --resume");
  }
  const StudyStore checked(settings.database, protocol);
  const std::vector<KnownSession> sessions = simulated_sessions(checked);
  require_same_kind(settings.database.string(), sessions, kind);
  require_same_version(settings.database.string(), checked.sessions(),
                       "simulate with that version, or into a new file");
  for (const KnownSession& session : sessions) {
    // A shard is one unit: the same on every machine that resumes it.
    if (settings.resume && (!has_ended(session) || settings.shard)) {
      require_resumable(settings, session);
    }
  }
}

void require_options(const SimulateSettings& settings) {
  require_ways_to_simulate(settings);
  if (settings.shard && settings.real_time) {
    throw UsageError("--shard",
                     "cannot be combined with --real-time, because shards need virtual time, which "
                     "is equal on all machines; remove "
                     "one of them");
  }
  if (settings.shard && settings.shard->count > settings.participants) {
    throw UsageError("--shard", fmt::format("there are more shards than participants; use at "
                                            "most {}",
                                            settings.participants));
  }
}

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

SimulateReport run_rendered(SimulatedStudy& study, const SimulationKind& kind, bool looks,
                            const std::stop_token& stop) {
  if (looks) {
    render_references(study.stages, study.protocol, study.workers, stop);
  }
  if (stop.stop_requested()) {
    return {};
  }
  if (kind.real_time) {
    return run_in_real_time(study, kind, stop);
  }
  study.make_attempts = [](const Workers& workers) {
    return [&workers](const TrialAttemptSetting& setting) -> std::unique_ptr<TrialAttempt> {
      return std::make_unique<RenderedAttempt>(setting, workers);
    };
  };
  return StudySimulation(study).run(stop);
}

SimulateReport run_predicted(SimulatedStudy& study, const Population& population, bool looks,
                             const std::stop_token& stop) {
  NoiseAtlas atlas;
  try {
    if (looks) {
      const PicturesWanted wanted =
          pictures_wanted(study, population.vision, sessions_ahead(study.settings, study.protocol));
      atlas = make_noise_atlas(atlas_setting(study, population, wanted), stop);
    }
  } catch (const Error&) {
    if (stop.stop_requested()) {
      return {};
    }
    throw;
  }
  const PredictedStudy predicted(study.protocol, study.stages, population, std::move(atlas));
  study.make_attempts = [&predicted](const Workers& /*workers*/) {
    return [&](const TrialAttemptSetting& setting) { return predicted.attempt(setting); };
  };
  return StudySimulation(study).run(stop);
}

}  // namespace

SimulateReport simulate_study(const SimulateSettings& settings, const SceneFinderBeside& find_scene,
                              std::stop_token stop) {
  require_options(settings);
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  const SimulationSetup setup = set_up_simulation(settings, find_scene);
  require_usable(settings, setup.protocol, setup.kind);
  if (settings.warns) {
    print_notes(setup.protocol.notes);
  }
  const Workers workers(settings.threads);
  const SceneStages stages =
      load_watched(stop, [&] { return load_stages(setup.protocol, setup.sources, workers); });
  print_scene_warnings(stages);
  SimulatedStudy study = study_of(settings, setup, stages, workers);
  if (fs::exists(settings.database)) {
    require_same_scenes(settings.database, study.shown);
  }
  SimulateReport report;
  if (settings.predicted) {
    report = run_predicted(study, setup.people.population, setup.simulates_viewing(), stop);
  } else {
    report = run_rendered(study, setup.kind, setup.simulates_viewing(), stop);
  }
  report.wall_s = seconds(clock.now() - start);
  return report;
}

}  // namespace foveola::study
