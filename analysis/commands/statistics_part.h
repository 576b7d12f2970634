// What a part of `bench statistics` says: its settings, and what it has counted.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/monte_carlo/coverage.h"
#include "analysis/monte_carlo/model_coverage.h"
#include "renderer/commands/bench_part.h"

namespace foveola::analysis {

inline constexpr const char* statistics_command = "statistics";

/// Models that R fits, in some of the cells.
struct ModelBench {
  ModelCoverageSettings settings;
  std::string only;       ///< what the cells have in their names; empty: all
  std::string fitted_by;  ///< of parts: R and its packages
};

nlohmann::json settings_json(const CoverageSettings& settings);
nlohmann::json settings_json(const ModelBench& bench);

bool is_of_models(const BenchPart& part);
CoverageSettings coverage_settings_of(const BenchPart& part);
ModelBench model_bench_of(const BenchPart& part);

nlohmann::json counts_json(const StudyCounts& counts);

/// The sums of what all parts of a whole counted, `figures` counts. Throws Error for a part that
/// does not have them.
StudyCounts merged_counts(const std::vector<BenchPart>& parts, std::size_t figures);

}  // namespace foveola::analysis
