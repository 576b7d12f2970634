// Very many paths over scenes whose radiance must be finite, in rounds that can be traced apart.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/base/shard.h"
#include "renderer/stability/effort.h"
#include "renderer/stability/figure.h"

namespace foveola {

/// What was found of some rounds.
struct FiniteRadiance {
  std::uint64_t paths = 0;   ///< that were traced
  std::uint64_t faults = 0;  ///< paths whose radiance is not finite, or negative
  std::string first_fault;   ///< where to find it again; empty if there is none

  /// Adds what was found of rounds behind these.
  void add(const FiniteRadiance& later);
};

/// How many rounds the effort's paths over so many scenes are: of each scene with each published
/// method, one after the other, as many as have StabilityEffort::round_paths each, the last one the
/// rest. The first of a scene and method has the effort's seed, each other one a seed made from it.
std::int64_t finite_radiance_rounds(const StabilityEffort& effort, std::size_t scenes);

/// Traces some of the rounds, in their order. The scenes' camera positions must be known. What a
/// run that is stopped returns is of no use. Throws Error for a scene that cannot be loaded.
FiniteRadiance trace_rounds(const StabilityRun& run, const std::vector<SceneSource>& scenes,
                            const ItemRange& rounds);

/// The figure of all rounds over scenes of these names.
StabilityFigure figure_of(const FiniteRadiance& found, const std::vector<std::string>& scenes);

}  // namespace foveola
