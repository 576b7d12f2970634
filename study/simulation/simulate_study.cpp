#include "study/simulation/simulate_study.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/build_info.h"
#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/progress.h"
#include "study/participant/effect_on_protocol.h"
#include "study/participant/judged_measures.h"
#include "study/participant/make_observer.h"
#include "study/participant/population_file.h"
#include "study/record/gaze_filter_json.h"
#include "study/record/same_scenes.h"
#include "study/record/simulation_kind.h"
#include "study/simulation/predicted_study.h"
#include "study/simulation/real_time_study.h"
#include "study/simulation/rendered_attempt.h"
#include "study/simulation/study_simulation.h"
#include "study/stage/protocol_notes.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

constexpr const char* no_injection = "none";

std::vector<KnownSession> simulated_sessions(const StudyStore& store) {
  std::vector<KnownSession> sessions = store.sessions();
  std::erase_if(sessions,
                [](const KnownSession& session) { return session.kind != SessionKind::simulated; });
  return sessions;
}

/// Throws Error unless this program with this seed can go on with `session`, or beside it.
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
      "finish it with that program, or take it out (foveola study forget) and simulate "
      "{} again",
      session.participant);
  const auto require_equal = [&](const std::string& then, const std::string& now) {
    if (then != now) {
      throw refused(fmt::format("{}, and this is {}", then, now), remedy);
    }
  };
  const BuildInfo now = build_info();
  require_equal(program_name(session.build), program_name(now));
  if (!session.build.instruction_set.empty()) {  // older programs did not keep it
    require_equal(exact_name(session.build), exact_name(now));
  }
}

/// Refuses a bad database before minutes of work instead of after them.
void require_usable(const SimulateSettings& settings, const Protocol& protocol,
                    const SimulationKind& kind) {
  require_writable(settings.database);
  if (!fs::exists(settings.database)) {
    return;
  }
  if (settings.shard && !settings.resume) {
    throw Error(settings.database.string(), "exists already, and a shard has a file of its own",
                "name a new file, or go on with this one with --resume");
  }
  const StudyStore checked(settings.database, protocol);
  const std::vector<KnownSession> sessions = simulated_sessions(checked);
  require_same_kind(settings.database.string(), sessions, kind);
  for (const KnownSession& session : sessions) {
    // A shard is one piece: the same on whichever machine it was gone on with.
    if (settings.resume && (!has_ended(session) || settings.shard)) {
      require_resumable(settings, session);
    }
  }
}

void require_options(const SimulateSettings& settings) {
  if (settings.participants < 1) {
    throw UsageError("--participants", "must be at least 1");
  }
  if (settings.jobs < 1) {
    throw UsageError("--jobs", "must be at least 1");
  }
  if (settings.shard && settings.real_time) {
    throw UsageError("--shard",
                     "is for virtual time, which is the same on every machine; leave "
                     "--real-time out, or this");
  }
  if (settings.shard && settings.shard->count > settings.participants) {
    throw UsageError("--shard", fmt::format("there are more shards than participants; write at "
                                            "most {} of them",
                                            settings.participants));
  }
  if (settings.real_time && settings.samples_per_second) {
    throw UsageError("--samples-per-second",
                     "is this machine's in real time; leave one of them out");
  }
  if (settings.real_time && settings.predicted) {
    throw UsageError("--real-time", "shows every frame; leave --predicted out, or this");
  }
  if (settings.real_time && settings.jobs > 1) {
    throw UsageError("--real-time",
                     "there is one window, for one session at a time; leave --jobs out");
  }
}

/// Who takes part, and what was injected in them.
struct Simulated {
  People people;
  std::optional<InjectedEffect> effect;
};

Simulated simulated_people(const SimulateSettings& settings) {
  Simulated simulated{.people = read_people(settings.people), .effect = std::nullopt};
  simulated.people.population.vision.coarseness = std::round(std::sqrt(settings.scale));
  if (settings.injected != no_injection) {
    simulated.effect = parse_injected_effect(settings.injected);
  }
  return simulated;
}

/// The protocol as these participants see it.
Protocol protocol_for(const Simulated& simulated, const SimulateSettings& settings,
                      const SimulationKind& kind) {
  Protocol protocol = simulated_protocol(load_protocol(settings.protocol), kind);
  if (!simulated.effect) {
    require_judgements(protocol);
  } else {
    require_drawable(*simulated.effect, protocol);
    if (simulated.effect->tracker_loss_part > 0.0) {
      protocol.tracker.simulated.data_loss = simulated.effect->tracker_loss_part;
    }
  }
  return protocol;
}

/// Of a predicted session there is no gaze to filter.
std::string devices_in_virtual_time(const SimulationKind& kind, const GazeFilterSettings& filter) {
  nlohmann::json devices = nlohmann::json::parse(devices_of(kind));
  if (!kind.predicted && filter != GazeFilterSettings{}) {
    devices["tracker"]["filter"] = json_of(filter);
  }
  return devices.dump();
}

std::vector<std::string> mark_ids(const Protocol& protocol) {
  std::vector<std::string> ids;
  for (const MarkEntry& mark : protocol.marks) {
    ids.push_back(mark.id);
  }
  return ids;
}

KnownScene knowledge_of(const SceneStages& stages, const std::string& scene) {
  const SceneStage& stage = *stages.at(scene);
  return {.panorama = &stage.reference(),
          .exposure_stops = stage.source().exposure_stops.value_or(0.0)};
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
  study.make_attempts = [](SimulatedObserver& /*observer*/, const Workers& workers) {
    return [&workers](const TrialAttemptSetting& setting) -> std::unique_ptr<TrialAttempt> {
      return std::make_unique<RenderedAttempt>(setting, workers);
    };
  };
  return StudySimulation(study).run(stop);
}

SimulateReport run_predicted(SimulatedStudy& study, const Population& population, bool looks,
                             const std::stop_token& stop) {
  constexpr double farthest = 3.0;  // standard deviations of the eye in the head
  NoiseAtlas atlas;
  try {
    if (looks) {
      atlas = make_noise_atlas(
          {.protocol = study.protocol,
           .stages = study.stages,
           .vision = population.vision,
           .highest_seen_deg =
               population.gaze.head_elevation_deg + farthest * population.gaze.eye_in_head_deg,
           .wanted = pictures_wanted(study, population.vision,
                                     sessions_ahead(study.settings, study.protocol)),
           .workers = study.workers,
           .cache = cache_folder() / "pilots"},
          stop);
    }
  } catch (const Error&) {
    if (stop.stop_requested()) {
      return {};
    }
    throw;
  }
  const PredictedStudy predicted(study.protocol, study.stages, population, std::move(atlas));
  study.make_attempts = [&predicted](SimulatedObserver& observer, const Workers& /*workers*/) {
    return [&](const TrialAttemptSetting& setting) { return predicted.attempt(setting, observer); };
  };
  return StudySimulation(study).run(stop);
}

}  // namespace

SimulateReport simulate_study(const SimulateSettings& settings, const SceneFinderBeside& find_scene,
                              std::stop_token stop) {
  require_options(settings);
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  const Simulated simulated = simulated_people(settings);
  const SimulationKind kind{.scale = settings.scale,
                            .samples_per_second = settings.samples_per_second,
                            .predicted = settings.predicted,
                            .real_time = settings.real_time,
                            .injected = settings.injected,
                            .people_sha256 = sha256(std::string_view(simulated.people.toml))};
  const Protocol protocol = protocol_for(simulated, settings, kind);
  const std::vector<SceneSource> sources = find_scenes(protocol, find_scene);
  require_usable(settings, protocol, kind);
  if (settings.warns) {
    print_notes(protocol);
  }
  const Workers workers(settings.threads);
  const SceneStages stages = load_stages(protocol, sources, workers);
  print_scene_warnings(stages);
  SimulatedStudy study{.settings = settings,
                       .protocol = protocol,
                       .stages = stages,
                       .workers = workers,
                       .make_observer = {},
                       .make_attempts = {},
                       .run_in_window = {},
                       .shown = shown_scenes(stages),
                       .devices = devices_in_virtual_time(kind, protocol.tracker.filter)};
  if (fs::exists(settings.database)) {
    require_same_scenes(settings.database, study.shown);
  }
  study.make_observer = [&](std::uint32_t seed, int design_row, const Plan& plan) {
    return make_observer(
        simulated.people.population, simulated.effect,
        [&stages](const std::string& scene) { return knowledge_of(stages, scene); },
        {.seed = seed, .row = design_row, .plan = plan, .marks = mark_ids(protocol)});
  };
  const bool looks = !simulated.effect;
  SimulateReport report;
  if (settings.predicted) {
    report = run_predicted(study, simulated.people.population, looks, stop);
  } else {
    report = run_rendered(study, kind, looks, stop);
  }
  report.wall_s = seconds(clock.now() - start);
  return report;
}

}  // namespace foveola::study
