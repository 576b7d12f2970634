#include "study/simulation/simulation_setup.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/base/transformed.h"
#include "study/participant/answers.h"
#include "study/participant/injected_effects/effect_on_protocol.h"
#include "study/participant/make_observer.h"
#include "study/record/log/gaze_filter_json.h"

namespace foveola::study {
namespace {

constexpr const char* no_injection = "none";

People people_of(const SimulateSettings& settings) {
  People people = read_people(settings.people);
  people.population.vision.coarseness = std::round(std::sqrt(settings.scale));
  return people;
}

std::optional<InjectedEffect> effect_of(const SimulateSettings& settings) {
  return settings.injected != no_injection ? std::optional(parse_injected_effect(settings.injected))
                                           : std::nullopt;
}

/// Returns the protocol as participants with such an effect see it.
Protocol protocol_for(const SimulateSettings& settings, const SimulationKind& kind,
                      const std::optional<InjectedEffect>& effect) {
  Protocol protocol = simulated_protocol(load_protocol(settings.protocol), kind);
  if (!effect) {
    require_judgements(protocol);
  } else {
    require_drawable(*effect, protocol);
    if (effect->tracker_loss_part > 0.0) {
      protocol.tracker.simulated.data_loss = effect->tracker_loss_part;
    }
  }
  return protocol;
}

/// Predicted sessions have no gaze to filter.
std::string devices_in_virtual_time(const SimulationKind& kind, const GazeFilterSettings& filter) {
  nlohmann::json devices = nlohmann::json::parse(devices_of(kind));
  if (!kind.predicted && filter != GazeFilterSettings{}) {
    devices["tracker"]["filter"] = json_of(filter);
  }
  return devices.dump();
}

std::vector<std::string> mark_ids(const Protocol& protocol) {
  return transformed(protocol.marks, &MarkEntry::id);
}

KnownScene knowledge_of(const SceneStages& stages, const std::string& scene) {
  const SceneStage& stage = *stages.at(scene);
  return {.panorama = &stage.reference(),
          .exposure_stops = stage.source().exposure_stops.value_or(0.0)};
}

}  // namespace

void require_ways_to_simulate(const SimulateSettings& settings) {
  if (settings.participants < 1) {
    throw UsageError("--participants", fmt::format("{} is too few", settings.participants),
                     "give at least 1");
  }
  if (settings.jobs < 1) {
    throw UsageError("--jobs", fmt::format("{} is too few", settings.jobs), "give at least 1");
  }
  if (settings.real_time && settings.samples_per_second) {
    throw UsageError(
        "--samples-per-second",
        "cannot be combined with --real-time, which uses this machine's speed; remove one of them");
  }
  if (settings.real_time && settings.predicted) {
    throw UsageError("--real-time", "cannot be combined with --predicted; remove one of them");
  }
  if (settings.real_time && settings.jobs > 1) {
    throw UsageError("--real-time",
                     "there is one window, for one session at a time; remove --jobs");
  }
}

SimulationSetup set_up_simulation(const SimulateSettings& settings,
                                  const SceneFinderBeside& find_scene) {
  People people = people_of(settings);
  std::optional<InjectedEffect> effect = effect_of(settings);
  const SimulationKind kind{.scale = settings.scale,
                            .samples_per_second = settings.samples_per_second,
                            .predicted = settings.predicted,
                            .real_time = settings.real_time,
                            .injected = settings.injected,
                            .people_sha256 = sha256(std::string_view(people.toml))};
  Protocol protocol = protocol_for(settings, kind, effect);
  std::vector<SceneSource> sources = find_scenes(protocol, find_scene);
  return {.people = std::move(people),
          .effect = std::move(effect),
          .kind = kind,
          .protocol = std::move(protocol),
          .sources = std::move(sources)};
}

SimulatedStudy study_of(const SimulateSettings& settings, const SimulationSetup& setup,
                        const SceneStages& stages, const Workers& workers) {
  SimulatedStudy study{
      .settings = settings,
      .protocol = setup.protocol,
      .stages = stages,
      .workers = workers,
      .make_observer = {},
      .make_attempts = {},
      .run_in_window = {},
      .shown = shown_scenes(stages),
      .devices = devices_in_virtual_time(setup.kind, setup.protocol.tracker.filter)};
  study.make_observer = [&setup, &stages](std::uint32_t seed, int design_row, const Plan& plan) {
    return make_observer(
        setup.people.population, setup.effect,
        [&stages](const std::string& scene) { return knowledge_of(stages, scene); },
        {.seed = seed, .row = design_row, .plan = plan, .marks = mark_ids(setup.protocol)});
  };
  return study;
}

AtlasSetting atlas_setting(const SimulatedStudy& study, const Population& population,
                           const PicturesWanted& wanted) {
  constexpr double farthest = 3.0;  // standard deviations of the eye in the head
  return {.protocol = study.protocol,
          .stages = study.stages,
          .vision = population.vision,
          .highest_seen_deg =
              population.gaze.head_elevation_deg + farthest * population.gaze.eye_in_head_deg,
          .wanted = wanted,
          .workers = study.workers,
          .cache = cache_folder() / "pilots"};
}

}  // namespace foveola::study
