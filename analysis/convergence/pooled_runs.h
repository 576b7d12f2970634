// Pools runs of `bench convergence` that differ only in scenes or seeds.
#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/convergence/measurement.h"

namespace foveola::analysis {

struct PooledRuns {
  nlohmann::ordered_json facts;  ///< as convergence_json() begins, without date and crops
  std::vector<GazeMeasurement> measurements;
};

/// Reads points.csv and convergence.json of at least one run, each in a folder of its own. Throws
/// Error for a folder without a run, for runs by other programs, on other machines or with other
/// plans, for different files of a scene's name, and for a seed that two runs of a scene share.
PooledRuns pool_runs(const std::vector<std::filesystem::path>& folders);

}  // namespace foveola::analysis
