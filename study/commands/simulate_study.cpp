#include "study/commands/simulate_study.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/progress.h"
#include "renderer/scene/load_scene.h"
#include "study/commands/participant_code.h"
#include "study/commands/same_scenes.h"
#include "study/commands/scene_stage.h"
#include "study/commands/seeds.h"
#include "study/commands/session_runner.h"
#include "study/participant/simulated_participant.h"
#include "study/record/shown_scene.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// The first participant who is not in the file yet: a study can be added to.
int first_new_participant(const StudyStore& store) {
  int index = 0;
  while (store.has_participant(participant_code(index))) {
    ++index;
  }
  return index;
}

/// Refuses a bad database before minutes of work instead of after them.
void require_usable(const fs::path& database, const Protocol& protocol) {
  require_writable(database);
  if (fs::exists(database)) {
    const StudyStore checked(database, protocol);
  }
}

SceneStages load_stages(const Protocol& protocol, const std::vector<SceneSource>& sources,
                        const Workers& workers) {
  SceneStages stages;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    stages[protocol.scenes[i].name] = std::make_unique<SceneStage>(sources[i], workers);
  }
  return stages;
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
      stage->render_reference(protocol, workers, show, stop);
    } catch (const Error&) {
      if (stop.stop_requested()) {
        return;
      }
      throw;
    }
    stages_done += 1.0;
  }
}

std::vector<ShownScene> shown_scenes(const SceneStages& stages) {
  std::vector<ShownScene> shown;
  for (const auto& [name, stage] : stages) {
    shown.push_back({.name = name,
                     .file_name = stage->source().file.filename().string(),
                     .sha256 = stage->scene().sha256,
                     .shown_as = shown_as(stage->source())});
  }
  return shown;
}

/// Whoever runs a study has to know; whoever reads its record can compare the hashes.
void warn_of_other_files(const SceneStages& stages) {
  for (const auto& [name, stage] : stages) {
    if (const auto warning = warning_of_another_file(stage->scene(), stage->source())) {
      fmt::print(stderr, "foveola: warning: {}: {}\n", name, *warning);
    }
  }
}

int scene_index(const Protocol& protocol, const std::string& name) {
  const auto found = std::find_if(protocol.scenes.begin(), protocol.scenes.end(),
                                  [&](const SceneEntry& scene) { return scene.name == name; });
  return static_cast<int>(found - protocol.scenes.begin());
}

int method_index(const Protocol& protocol, const std::string& name) {
  const auto found = std::find(protocol.methods.begin(), protocol.methods.end(), name);
  return static_cast<int>(found - protocol.methods.begin());
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
    const int first = first_new_participant(store_);
    for (int done = 0; done < settings_.participants && !stop.stop_requested(); ++done) {
      run_participant(first + done, done, stop);
    }
    return report_;
  }

 private:
  void run_participant(int index, int done, const std::stop_token& stop) {
    const Plan plan = random_plan(protocol_, settings_.seed, index);
    const std::int64_t session = store_.begin_session(facts_of(index), plan);
    SimulatedParticipant participant(
        Population{}, [this](const std::string& scene) { return knowledge_of(scene); },
        derive_seed(settings_.seed, SeedPurpose::participant, {index}));
    const SessionSetting setting{
        .protocol = protocol_,
        .stages = stages_,
        .store = store_,
        .workers = workers_,
        .seeds = [&](const PlannedTrial& trial,
                     int attempt) { return seeds_of(index, trial, attempt); },
        .validation_seed = derive_seed(settings_.seed, SeedPurpose::tracker, {index}),
        .on_trial = [&](std::size_t trial) { show(done, trial, plan); },
        .stop = stop};
    add(SessionRunner(setting, plan, session, participant).run());
  }

  SessionFacts facts_of(int index) const {
    return {.participant = participant_code(index),
            .kind = SessionKind::simulated,
            .seed = settings_.seed,
            .build = build_info(),
            .machine = machine_info(),
            .scenes = shown_};
  }

  AttemptSeeds seeds_of(int index, const PlannedTrial& trial, int attempt) const {
    const auto seed = [&](SeedPurpose purpose) {
      return derive_seed(settings_.seed, purpose,
                         {index, scene_index(protocol_, trial.scene),
                          method_index(protocol_, trial.method), attempt});
    };
    return {.tracker = seed(SeedPurpose::tracker), .rendering = seed(SeedPurpose::rendering)};
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
  require_usable(settings.database, protocol);
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
