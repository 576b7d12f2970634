// Renders the images that a simulation needs before its first session into the caches, which many
// machines may share.
#pragma once

#include <cstdint>
#include <stop_token>

#include "study/simulation/simulate_study.h"

namespace foveola::study {

struct PrepareReport {
  /// Number of images of this shard: scenes' references, or the pilots' surroundings and objects.
  std::int64_t items = 0;
  std::int64_t rendered = 0;      ///< items that were not in the cache
  bool simulates_viewing = true;  ///< whether participants look at pictures; if not, no items
  bool stopped = false;           ///< before all were rendered; those rendered are in the cache
  double wall_s = 0.0;
};

/// Renders the missing items for simulating all participants of a new study: the reference of each
/// scene or, for a predicted study, the pilot renders. A shard renders its part only, independently
/// of the others. find_scene returns the file of a scene that the protocol names. Shows progress.
/// Throws UsageError for settings that contradict each other, and Error if a file cannot be read or
/// the cache cannot be written.
PrepareReport prepare_study(const SimulateSettings& settings, const SceneFinderBeside& find_scene,
                            const std::stop_token& stop);

}  // namespace foveola::study
