// Writes measurements of convergence as CSV, as JSON and as text.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/convergence/convergence_tables.h"
#include "analysis/tables/text_file.h"

namespace foveola::analysis {

/// Returns points.csv (every checkpoint), speed_ups.csv, costs.csv, convergence.csv and
/// overall.csv. Missing values are empty fields.
std::vector<TextFile> convergence_csv(const std::vector<GazeMeasurement>& measurements,
                                      const ConvergenceTables& tables);

/// Returns the baseline, the plan, and the content of the crops.
nlohmann::ordered_json plan_facts(const ConvergencePlan& plan);

/// Returns the tables as a JSON object that begins with `facts`: of the program, the machine and
/// the plan. Every estimate is {"value", "low", "high"}, or null.
std::string convergence_json(nlohmann::ordered_json facts,
                             const std::vector<GazeMeasurement>& measurements,
                             const ConvergenceTables& tables);

/// Returns the summary for the terminal: speed-ups in mean squared error at equal error, by region,
/// with costs.
std::string convergence_summary(const ConvergenceTables& tables);

}  // namespace foveola::analysis
