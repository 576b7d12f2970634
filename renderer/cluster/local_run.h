// A job's scripts on this machine, without Slurm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "renderer/cluster/job_folder.h"

namespace foveola {

/// What became of a script.
struct ScriptEnd {
  std::int64_t number = 0;  ///< of its part
  int status = 0;           ///< of the last try, as wait() has it
};

/// Runs a stage's script for these parts, so many processes at once, each until it no longer asks
/// to be run again; what they say goes to their logs. When stopped, asks those that run to end and
/// begins no other. Calls `ended` with how many will not run again, whenever that changes. Returns
/// those that failed, in the order of their numbers. Throws std::system_error if bash cannot be
/// started.
std::vector<ScriptEnd> run_here(const JobFolder& folder, Stage stage,
                                const std::vector<std::int64_t>& numbers, std::int64_t at_once,
                                const std::function<void(std::size_t)>& ended,
                                const std::stop_token& stop);

}  // namespace foveola
