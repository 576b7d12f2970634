// Running a plan: by Slurm, or on this machine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>

#include "renderer/cluster/cluster_plan.h"
#include "renderer/cluster/job_folder.h"

namespace foveola {

struct SubmitSettings {
  std::filesystem::path results;  ///< absolute
  std::string partition;          ///< empty: Slurm's default
  std::int64_t at_once = 0;       ///< parts at a time; 0: as many as Slurm has room for
};

/// The scripts and what would be submitted, as text. Writes nothing.
std::string dry_run(const ClusterPlan& plan, const SubmitSettings& settings);

/// Submits what is not done of each job: what fills its caches, its shards after that, and its
/// merge after these; returns a line for each job. Throws Error if some of it is still in Slurm's
/// queue.
std::string submit(const ClusterPlan& plan, const SubmitSettings& settings);

/// The same here, by processes of this machine, `at_once` of them at a time (0: one). Prints how
/// far it has come. Throws Error at the end if something failed; the other jobs are then done.
void run_plan_here(const ClusterPlan& plan, const SubmitSettings& settings,
                   const std::stop_token& stop);

}  // namespace foveola
