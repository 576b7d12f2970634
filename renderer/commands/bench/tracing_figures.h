// The figures of `bench tracing`, and their printing.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/commands/bench_facts.h"
#include "renderer/trace/paths/path_tracer.h"
#include "renderer/trace/rays/embree_alone.h"

namespace foveola {

/// A kind of ray, and its number of queries.
struct RayKind {
  const char* name;
  std::uint64_t RayCounts::* count;
  std::vector<Ray> RayLog::* rays;
  RayQuery query;
};
inline constexpr std::array<RayKind, 4> ray_kinds{
    {{"primary", &RayCounts::primary, &RayLog::primary, RayQuery::closest_hit},
     {"bounce", &RayCounts::bounce, &RayLog::bounce, RayQuery::closest_hit},
     {"shadow", &RayCounts::shadow, &RayLog::shadow, RayQuery::is_blocked},
     {"transmittance", &RayCounts::transmittance, &RayLog::transmittance, RayQuery::closest_hit}}};

/// Embree's own time for the rays of a kind.
struct EmbreeFigure {
  std::string kind;
  std::string entry_point;  ///< the fastest
  double seconds = 0.0;
  std::vector<std::pair<std::string, Median>> all;  ///< seconds by entry point
};

/// The general path compared with the fast path.
struct GeneralFigures {
  Median seconds;
  Median gain;  ///< its seconds over the default path's, repetition by repetition
};

/// Times are medians over the repetitions.
struct TracingFigures {
  int threads = 0;
  std::vector<std::string> warnings;  ///< warnings of loading the scene
  Median seconds;                     ///< seconds for all paths: sampled, traced and filmed
  RayCounts rays;
  std::vector<EmbreeFigure> embree;
  Median embree_seconds;   ///< seconds for the same rays, each kind by its fastest entry point
  Median ratio_to_embree;  ///< median over the repetitions, both measured in the same one
  std::optional<GeneralFigures> general;
};

/// paths: the number of paths of each repetition.
nlohmann::ordered_json json_of(const TracingFigures& figures, std::uint64_t paths);
void print_table(const std::vector<TracingFigures>& runs, std::uint64_t paths);

}  // namespace foveola
