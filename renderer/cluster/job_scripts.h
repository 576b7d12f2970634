// The scripts of a job: plain ones for bash, which Slurm runs as they are, and so can anyone.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/cluster/job_folder.h"

namespace foveola {

/// What all scripts of a plan have in common.
struct ScriptSetting {
  std::filesystem::path program;      ///< absolute, where every machine sees it
  std::filesystem::path plan_folder;  ///< where the commands run
  std::string plan_name;
  std::vector<std::string> slurm_options;  ///< of sbatch, for each of the scripts
  std::int64_t at_once = 0;  ///< parts at the same time; 0: as many as there is room for
};

/// A script ends with this where it is to be run again: its time was up, or it was killed. Slurm is
/// told so by the script itself.
inline constexpr int run_again_exit_code = 75;

/// The script of a stage. It takes the number of a part from SLURM_ARRAY_TASK_ID, or as its
/// argument. Throws Error for a folder whose name Slurm cannot have in a script.
std::string job_script(Stage stage, const ScriptSetting& setting, const ClusterJob& job,
                       const JobFolder& folder);

/// A word as bash reads it: in quotes if need be.
std::string shell_quoted(const std::string& word);

/// "1-3,7" of 1, 2, 3 and 7, as Slurm writes lists; numbers: ascending.
std::string number_ranges(const std::vector<std::int64_t>& numbers);

}  // namespace foveola
