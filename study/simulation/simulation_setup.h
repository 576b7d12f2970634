// Loads a simulation's people, scaled protocol and scenes.
#pragma once

#include <optional>
#include <vector>

#include "study/participant/injected_effects/injected_effect.h"
#include "study/participant/population_file.h"
#include "study/prediction/noise_atlas.h"
#include "study/protocol/protocol.h"
#include "study/record/setup/simulation_kind.h"
#include "study/simulation/study_simulation.h"

namespace foveola::study {

/// The inputs of a simulation, before any scene is loaded.
struct SimulationSetup {
  People people;
  std::optional<InjectedEffect> effect;  ///< injected effect
  SimulationKind kind;
  Protocol protocol;  ///< as the participants see it
  std::vector<SceneSource> sources;

  /// Whether participants look at pictures: not with injected times.
  bool simulates_viewing() const { return !effect; }
};

/// Throws UsageError for settings that exclude one another in any use.
void require_ways_to_simulate(const SimulateSettings& settings);

/// Throws Error if the protocol or the people cannot be read, or do not go together.
SimulationSetup set_up_simulation(const SimulateSettings& settings,
                                  const SceneFinderBeside& find_scene);

/// Returns the study of such settings, without attempts. It refers to all arguments.
SimulatedStudy study_of(const SimulateSettings& settings, const SimulationSetup& setup,
                        const SceneStages& stages, const Workers& workers);

/// Returns the pilots for these people's predicted looks, cached in the user's folder. It refers to
/// all arguments.
AtlasSetting atlas_setting(const SimulatedStudy& study, const Population& population,
                           const PicturesWanted& wanted);

}  // namespace foveola::study
