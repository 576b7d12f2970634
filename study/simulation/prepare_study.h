// Renders the images that a simulation needs before its first session into the caches, which many
// machines may share.
#pragma once

#include <cstdint>
#include <stop_token>

#include "study/simulation/simulate_study.h"

namespace foveola::study {

struct PrepareReport {
  std::int64_t items = 0;     ///< of the shard: references of scenes, or surrounds and objects
  std::int64_t rendered = 0;  ///< items that were not in the cache
  bool has_looks = true;  ///< whether participants look at pictures; otherwise there are no items
  bool stopped = false;   ///< before all were there; rendered items are kept
  double wall_s = 0.0;
};

/// Renders the missing items for simulating all participants of a new study: the reference of each
/// scene or, for a predicted study, the pilots. A shard renders its part only, independently of the
/// others. Shows progress. Throws UsageError and Error as simulate_study.
PrepareReport prepare_study(const SimulateSettings& settings, const SceneFinderBeside& find_scene,
                            const std::stop_token& stop);

}  // namespace foveola::study
