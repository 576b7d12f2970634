#include "renderer/cluster/job_scripts.h"

#include <gmock/gmock.h>

#include "renderer/base/error.h"
#include "renderer/base/programs.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

ClusterJob job_of(const SplitCommand& command) {
  const std::string extension =
      command.result_extensions.empty() ? "" : std::string(command.result_extensions.front());
  return {.name = "night",
          .words = {"bench", "it's", "a b"},
          .command = command,
          .shards = 16,
          .prepare_shards = 4,
          .output = "result" + extension,
          .time_limit = "08:00:00",
          .cores = 2,
          .memory = "4G"};
}

const ScriptSetting setting{.program = "/opt/foveola/bin/foveola",
                            .plan_folder = "/home/someone/my plans",
                            .plan_name = "night.toml",
                            .slurm_options = {"--account=vision"},
                            .at_once = 3};

std::string script_of(Stage stage, const ClusterJob& job) {
  return job_script(stage, setting, job, JobFolder("/home/someone/my plans/night", job));
}

TEST(JobScripts, AreBash) {
  const test::TemporaryFolder folder;
  for (const SplitCommand& command : split_commands()) {
    for (const Stage stage : {Stage::prepare, Stage::shards, Stage::merge}) {
      const std::string script = script_of(stage, job_of(command));
      const std::string file = folder.write("script.sh", script).string();
      const ProgramEnd end = run_to_end({.words = {"bash", "-n", file}});
      EXPECT_EQ(end.status, 0) << end.errors << script;
      for (const char* const placeholder : {"@EXTENSION@", "@MERGE@", "@JSON@"}) {
        EXPECT_EQ(script.find(placeholder), script.npos) << placeholder;
      }
    }
  }
}

TEST(JobScripts, TellSlurmWhatTheyNeed) {
  ClusterJob job = job_of(*find_split_command({"render"}));
  EXPECT_THAT(script_of(Stage::shards, job),
              AllOf(HasSubstr("#!/bin/bash\n"), HasSubstr("\n#SBATCH --array=1-16%3\n"),
                    HasSubstr("\n#SBATCH --cpus-per-task=2\n"), HasSubstr("\n#SBATCH --mem=4G\n"),
                    HasSubstr("\n#SBATCH --time=08:00:00\n#SBATCH --signal=B:USR1@120\n"),
                    HasSubstr("\n#SBATCH --requeue\n"), HasSubstr("\n#SBATCH --account=vision\n"),
                    HasSubstr("night/jobs/night/logs/shard-%a.log\"\n")));
  EXPECT_THAT(script_of(Stage::merge, job),
              AllOf(Not(HasSubstr("--array")), HasSubstr("/logs/merge.log\"\n"),
                    HasSubstr("#SBATCH --account=vision\n")));
  job.cores = 0;
  job.time_limit.clear();
  EXPECT_THAT(script_of(Stage::shards, job),
              AllOf(HasSubstr("\n#SBATCH --exclusive\n"), Not(HasSubstr("--time")),
                    Not(HasSubstr("--signal"))));
}

TEST(JobScripts, GiveTheCommandItsPart) {
  EXPECT_THAT(script_of(Stage::shards, job_of(*find_split_command({"study", "simulate"}))),
              HasSubstr("\"$foveola\" bench 'it'\\''s' 'a b' --db \"$work\" --resume --shard "
                        "\"$shard/16\" --threads \"${SLURM_CPUS_ON_NODE:-2}\" &\n"));
  EXPECT_THAT(script_of(Stage::prepare, job_of(*find_split_command({"study", "simulate"}))),
              HasSubstr("'a b' --prepare --shard \"$shard/4\" "));
  EXPECT_THAT(script_of(Stage::shards, job_of(*find_split_command({"bench", "statistics"}))),
              AllOf(HasSubstr("--output \"$work\" --shard"), Not(HasSubstr("--resume"))));
}

TEST(JobScripts, CannotLieInAFolderThatSlurmMisreads) {
  const ClusterJob job = job_of(*find_split_command({"render"}));
  for (const char* const folder : {"/home/100%", "/home/a\"b", "/home/it's", "/home/a\\b"}) {
    EXPECT_THAT([&] { job_script(Stage::merge, setting, job, JobFolder(folder, job)); },
                testing::ThrowsMessage<Error>(HasSubstr("name a folder without them")))
        << folder;
  }
}

TEST(JobScripts, QuoteWhatBashWouldRead) {
  EXPECT_EQ(shell_quoted("--method=hybrid:0.9"), "--method=hybrid:0.9");
  EXPECT_EQ(shell_quoted(""), "''");
  EXPECT_EQ(shell_quoted("$(rm -rf ~)"), "'$(rm -rf ~)'");
  EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
}

TEST(JobScripts, WriteNumbersAsSlurmDoes) {
  EXPECT_EQ(number_ranges({1, 2, 3, 7, 9, 10}), "1-3,7,9-10");
  EXPECT_EQ(number_ranges({5}), "5");
  EXPECT_EQ(number_ranges({}), "");
}

}  // namespace
}  // namespace foveola
