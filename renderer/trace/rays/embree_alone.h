// Measures Embree's time for given rays by each of its entry points: the baseline for a tracer.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

enum class RayQuery { closest_hit, is_blocked };

struct EmbreeTime {
  std::string entry_point;  ///< "rtcIntersect1M of 64, coherent"
  double seconds = 0.0;     ///< in Embree and its filters, for rays in its own layout
};

/// Traces the rays in order by every entry point that supports the query.
std::vector<EmbreeTime> time_embree(const RayScene& scene, std::span<const Ray> rays,
                                    RayQuery query, const Workers& workers);

}  // namespace foveola
