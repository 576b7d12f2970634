// How far the jobs of a plan have come, by what lies in their folders and what Slurm has of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/cluster/job_folder.h"
#include "renderer/cluster/slurm.h"

namespace foveola {

enum class PartState : std::uint8_t {
  done,
  running,
  waiting,  ///< in Slurm's queue
  ended,    ///< it has run, is not done and will not be by itself
  not_run
};

struct PartStatus {
  std::int64_t number = 0;
  PartState state = PartState::not_run;
  std::string last_line;  ///< of its log
};

/// A stage of a job.
struct StageStatus {
  Stage stage = Stage::shards;
  std::vector<PartStatus> parts;  ///< all of them, from 1 on

  std::int64_t count(PartState state) const;
};

struct JobStatus {
  std::string name;
  std::filesystem::path output;
  std::vector<StageStatus> stages;  ///< in order; without preparing if nothing is
};

/// tasks: what is in Slurm's queue. runs_here: whether a process of this machine runs the plan, so
/// that what has begun may still be running.
JobStatus status_of(const ClusterJob& job, const JobFolder& folder,
                    const std::vector<QueuedTask>& tasks, bool runs_here);

/// Whether any of it waits or runs.
bool is_under_way(const JobStatus& status);
/// Whether something ended without being done.
bool has_failed(const JobStatus& status);

/// Some lines for the terminal.
std::string in_words(const JobStatus& status);

/// "done", "running" ...
const char* name_of(PartState state);

}  // namespace foveola
