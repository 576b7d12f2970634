// A measurement of convergence as CSV, as JSON and in words.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/convergence/convergence_tables.h"
#include "analysis/tables/text_file.h"

namespace foveola::analysis {

/// points.csv (every checkpoint), speed_ups.csv, costs.csv, convergence.csv, overall.csv. What does
/// not exist is an empty field.
std::vector<TextFile> convergence_csv(const std::vector<GazeMeasurement>& measurements,
                                      const ConvergenceTables& tables);

/// Who measured one part of a measurement that was split, and what.
struct MeasuringMachine {
  std::string shard;  ///< "3/8"
  std::string processor;
  int cores = 0;
  int threads = 0;
  std::vector<std::string> repetitions;  ///< "0 to 3 of arcade at 0,0"
};

/// The tables with the plan, as a JSON object that begins with `facts`: the program's, and the
/// machine's unless there are `machines`, those of all parts; then there are no crops. Every
/// estimate is {"value", "low", "high"}, or null.
std::string convergence_json(const nlohmann::ordered_json& facts, const ConvergencePlan& plan,
                             const std::vector<GazeMeasurement>& measurements,
                             const ConvergenceTables& tables,
                             const std::vector<MeasuringMachine>& machines = {});

/// The summary for the terminal: speed-ups in mean squared error at equal error, by region, with
/// costs.
std::string convergence_summary(const ConvergenceTables& tables);

}  // namespace foveola::analysis
