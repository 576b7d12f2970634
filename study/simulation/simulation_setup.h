// What a simulation is made from before anybody takes part: its people, its protocol as they see
// it, and its scenes.
#pragma once

#include <optional>
#include <vector>

#include "study/participant/injected_effects/injected_effect.h"
#include "study/participant/population_file.h"
#include "study/prediction/noise_atlas.h"
#include "study/protocol/protocol.h"
#include "study/record/simulation_kind.h"
#include "study/simulation/study_simulation.h"

namespace foveola::study {

/// Who takes part in what, of which no scene is loaded yet.
struct SimulationSetup {
  People people;
  std::optional<InjectedEffect> effect;  ///< what was injected in them
  SimulationKind kind;
  Protocol protocol;  ///< as they see it
  std::vector<SceneSource> sources;

  /// Whether anybody looks at pictures: whose times are injected does not.
  bool has_looks() const { return !effect; }
};

/// Throws UsageError for settings that exclude one another, whatever is done with them.
void require_ways_to_simulate(const SimulateSettings& settings);

/// Throws Error if the protocol or the people cannot be read, or do not go together.
SimulationSetup set_up_simulation(const SimulateSettings& settings,
                                  const SceneFinderBeside& find_scene);

/// The study of such settings, whose attempts are not chosen yet. It refers to all of them.
SimulatedStudy study_of(const SimulateSettings& settings, const SimulationSetup& setup,
                        const SceneStages& stages, const Workers& workers);

/// The pilots that predicted looks of these people need, kept among the user's caches. It refers to
/// all of them.
AtlasSetting atlas_setting(const SimulatedStudy& study, const Population& population,
                           const PicturesWanted& wanted);

}  // namespace foveola::study
