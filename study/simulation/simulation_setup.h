// What a simulation is made from before anybody takes part: its people, its protocol as they see
// it, and its scenes.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "study/participant/injected_effect.h"
#include "study/participant/population_file.h"
#include "study/prediction/noise_atlas.h"
#include "study/protocol/protocol.h"
#include "study/record/simulation_kind.h"
#include "study/simulation/simulate_study.h"
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

struct PrepareReport {
  std::int64_t items = 0;     ///< of the shard: references of scenes, or surrounds and objects
  std::int64_t rendered = 0;  ///< the others were in the cache
  bool has_looks = true;      ///< whether anybody looks at pictures; if not, there are no items
  bool stopped = false;       ///< before all were there: what was rendered is kept
  double wall_s = 0.0;
};

/// Renders what the caches lack for simulating all participants of a new study: the reference of
/// each scene or, of a predicted study, the pilots. Of a shard only its part of these, which needs
/// nothing of the others'. Shows progress. Throws UsageError and Error as simulate_study.
PrepareReport prepare_study(const SimulateSettings& settings, const SceneFinderBeside& find_scene,
                            const std::stop_token& stop);

}  // namespace foveola::study
