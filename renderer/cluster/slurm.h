// Slurm's own commands, as far as plans need them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace foveola {

/// Submits a script; further: options beside those in it. Returns the job's number. Throws Error
/// with what sbatch says if it refuses, or if Slurm is not there.
std::uint64_t submit_to_slurm(const std::filesystem::path& script,
                              const std::vector<std::string>& further);

/// Takes a job out of the queue, and ends what runs of it; it may be over already.
void cancel_in_slurm(std::uint64_t job);

/// A task of a job that is in the queue: waiting, running or ending.
struct QueuedTask {
  std::uint64_t job = 0;
  std::int64_t number = 0;  ///< in its array; 0 of a job that is none
  std::string state;        ///< "PENDING", "RUNNING" ...
  std::string reason;       ///< why it waits
};

/// The user's tasks that are in Slurm's queue. Throws Error if Slurm does not answer.
std::vector<QueuedTask> queued_in_slurm();

}  // namespace foveola
