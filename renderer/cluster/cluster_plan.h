// A plan: long work, job by job, and into how many shards each is split. A file of the user's.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/cluster/split_command.h"

namespace foveola {

/// Beside the results: all that the jobs need and leave.
inline constexpr const char* folder_of_jobs = "jobs";

struct ClusterJob {
  std::string name;                 ///< letters, digits, - and _; its folder's name
  std::vector<std::string> words;   ///< the command, without "foveola" and what parts get
  SplitCommand command{};           ///< which one that is
  std::int64_t shards = 1;          ///< from 1 to most_shards
  std::int64_t prepare_shards = 0;  ///< that fill caches first; 0: none do
  std::string output;               ///< name of the merged file or folder, not folder_of_jobs
  std::string time_limit;           ///< of a shard, as Slurm writes it; empty: the partition's
  int cores = 0;                    ///< of a shard; 0: all of a node
  std::string memory;               ///< of a shard, as Slurm writes it; empty: the partition's
};

struct ClusterPlan {
  std::filesystem::path file;  ///< absolute
  std::string text;            ///< of the file
  std::vector<ClusterJob> jobs;
  std::vector<std::string> slurm_options;  ///< further ones, as "--account=vision"

  /// Where the commands run: relative paths in them begin here.
  std::filesystem::path folder() const { return file.parent_path(); }
};

/// Throws Error with the place of whatever is wrong, among it a command that cannot be split.
ClusterPlan read_cluster_plan(const std::filesystem::path& file);

}  // namespace foveola
