// Where a plan's jobs keep their scripts, parts and logs: a folder that all machines see.
//
// RESULTS/                   one for each plan
//   study.sqlite             what was merged
//   jobs/plan.toml           the plan that it is of
//   jobs/program.txt         and the program
//   jobs/cohort/shard.sh     the scripts: prepare.sh, shard.sh, merge.sh
//   jobs/cohort/parts/       finished parts, each renamed into its place when it was whole
//   jobs/cohort/prepared/    an empty file for each part of preparing that is done
//   jobs/cohort/unfinished/  parts as they were when they were stopped
//   jobs/cohort/logs/        what each shard said, over all tries
//   jobs/cohort/slurm.txt    the numbers that Slurm gave to what was submitted last
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "renderer/cluster/cluster_plan.h"

namespace foveola {

/// A step of a job, of which each comes after all of the one before.
enum class Stage : std::uint8_t { prepare, shards, merge };

/// "prepare", "shard" or "merge": how its script and its logs are called.
const char* name_of(Stage stage);

/// "8 shards", "1 part of preparing" or "the merge".
std::string parts_in_words(Stage stage, std::size_t count);

class JobFolder {
 public:
  /// results: absolute, the plan's folder of results. Makes nothing.
  JobFolder(const std::filesystem::path& results, const ClusterJob& job);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path script(Stage stage) const;
  /// Of a stage of preparing or of shards that of one part; of merging the only one.
  std::filesystem::path log(Stage stage, std::int64_t number) const;
  /// What is there when it is done.
  std::filesystem::path done(Stage stage, std::int64_t number) const;
  const std::filesystem::path& output() const { return output_; }

  std::int64_t count(Stage stage) const;
  /// The numbers, from 1 on, of what is not done yet.
  std::vector<std::int64_t> missing(Stage stage) const;

  /// Makes the folder and those in it. Throws Error if that fails.
  void make() const;

  /// The numbers of Slurm's jobs by stages; empty if there are none.
  std::map<Stage, std::uint64_t> slurm_jobs() const;
  void keep_slurm_jobs(const std::map<Stage, std::uint64_t>& jobs) const;

 private:
  std::filesystem::path path_;
  std::filesystem::path output_;
  std::string part_extension_;
  std::int64_t shards_;
  std::int64_t prepare_shards_;
};

/// The last line with anything in it; empty if there is none, or no such file.
std::string last_line(const std::filesystem::path& log);

/// Which plan and program a folder of results is of. `begin` makes it that of both, if it is new.
/// Throws Error if it is of others: parts by another program could not be merged.
void begin_results(const std::filesystem::path& results, const ClusterPlan& plan);

/// Held by whoever submits or runs a plan: throws Error if another process does.
class ResultsLock {
 public:
  explicit ResultsLock(const std::filesystem::path& results);
  ~ResultsLock();
  ResultsLock(const ResultsLock&) = delete;
  ResultsLock& operator=(const ResultsLock&) = delete;

 private:
  int descriptor_;
};

/// Whether a process on this machine holds it.
bool is_locked(const std::filesystem::path& results);

}  // namespace foveola
