// What a simulation would have to render before its first session, rendered ahead of it into the
// caches, which many machines may share.
#pragma once

#include <cstdint>
#include <stop_token>

#include "study/simulation/simulate_study.h"

namespace foveola::study {

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
