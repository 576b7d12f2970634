// What a part of `bench convergence` says: its settings, its machine, and all that it has measured.
#pragma once

#include <vector>

#include "analysis/commands/convergence_run.h"
#include "analysis/convergence/convergence_files.h"
#include "renderer/commands/bench_part.h"

namespace foveola::analysis {

inline constexpr const char* convergence_command = "convergence";

/// measured: what measure_part() returned for the shard.
BenchPart convergence_part(const ConvergenceRun& run, const Shard& shard,
                           const std::vector<MeasuredPart>& measured);

/// All parts together.
struct MergedConvergence {
  /// What the tables name of it: of its configurations their names and methods alone.
  ConvergencePlan plan;
  std::vector<GazeMeasurement> measurements;
  std::vector<MeasuringMachine> machines;
};

/// Of a whole (see read_whole_bench). Throws Error for parts that do not fit together.
MergedConvergence merged_convergence(const std::vector<BenchPart>& parts);

}  // namespace foveola::analysis
