// Plans of long work: run here, and submitted to a Slurm of which only the commands are there.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "renderer/base/files.h"
#include "tests/end_to_end/program.h"
#include "tests/temporary_folder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::IsEmpty;

/// As Slurm's command: keeps how it was called.
constexpr const char* sbatch = R"(#!/bin/bash
echo "sbatch $*" >>"$SLURM_CALLS"
case "$*" in *merge.sh) [ -z "${REFUSES_MERGES:-}" ] || { echo 'Invalid account' >&2; exit 1; } ;; esac
wc -l <"$SLURM_CALLS"
)";
constexpr const char* scancel = "#!/bin/bash\necho \"scancel $*\" >>\"$SLURM_CALLS\"\n";
/// What `QUEUE` has.
constexpr const char* squeue = "#!/bin/bash\nprintf '%s' \"${QUEUE:-}\"\n";

class Cluster : public testing::Test {
 protected:
  Cluster() {
    folder_.write("room.gltf", room_gltf());
    for (const auto& [name, script] :
         {std::pair{"sbatch", sbatch}, {"scancel", scancel}, {"squeue", squeue}}) {
      fs::permissions(folder_.write(std::string("slurm/") + name, script), fs::perms::owner_all);
    }
    plan_ = folder_.write("night.toml", "[[job]]\nname = \"room\"\ncommand = \"render " +
                                            (folder_ / "room.gltf").string() +
                                            " --panorama --size 64x32 --spp 4 --camera 0,1,0\"\n"
                                            "shards = 3\ncores = 1\noutput = \"room.exr\"\n");
  }

  ProgramResult cluster(std::vector<std::string> arguments, const Environment& environment = {}) {
    arguments.insert(arguments.begin(), "cluster");
    Environment with_slurm = {{"PATH", (folder_ / "slurm").string() + ":/usr/bin:/bin"},
                              {"SLURM_CALLS", (folder_ / "calls").string()}};
    with_slurm.insert(with_slurm.end(), environment.begin(), environment.end());
    return run_foveola(arguments, with_slurm);
  }

  std::string calls() const {
    return fs::exists(folder_ / "calls") ? read_file(folder_ / "calls") : "";
  }

  TemporaryFolder folder_;
  fs::path plan_;
};

TEST_F(Cluster, APlanThatRunsHereMakesWhatOneCommandWouldHave) {
  const ProgramResult result = cluster({"submit", plan_, "--local", "--nodes", "2"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const fs::path whole = folder_ / "whole.exr";
  ASSERT_EQ(run_foveola({"render", folder_ / "room.gltf", "--panorama", "--size", "64x32", "--spp",
                         "4", "--camera", "0,1,0", "-o", whole})
                .exit_code,
            0);
  EXPECT_TRUE(read_file(folder_ / "night/room.exr") == read_file(whole));
  EXPECT_THAT(cluster({"status", plan_}).output, HasSubstr("3 shards: 3 done\n  merged: "));
  EXPECT_THAT(cluster({"submit", plan_, "--local"}).output, HasSubstr("night/room.exr"));
  EXPECT_THAT(calls(), IsEmpty());
}

TEST_F(Cluster, WhatFailsHereIsNamedAndGoneOnWith) {
  folder_.write("night/jobs/room/unfinished/2.film", "damaged");
  const ProgramResult failed = cluster({"submit", plan_, "--local"});
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.errors, HasSubstr("room: shard 2 failed (exit status 1): foveola: error: "));
  EXPECT_THAT(failed.errors, HasSubstr("night.toml: not done: room; mend it"));
  EXPECT_FALSE(fs::exists(folder_ / "night/room.exr"));
  const ProgramResult status = cluster({"status", plan_, "--wait"});
  EXPECT_EQ(status.exit_code, 1);
  EXPECT_THAT(status.output, HasSubstr("not merged, since something failed"));
  fs::remove(folder_ / "night/jobs/room/unfinished/2.film");
  EXPECT_EQ(cluster({"submit", plan_, "--local"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "night/room.exr"));
}

TEST_F(Cluster, AnArrayAndItsMergeAreSubmitted) {
  const ProgramResult result = cluster({"submit", plan_, "--partition", "compute", "--nodes", "2"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const std::string scripts = (folder_ / "night/jobs/room/").string();
  EXPECT_EQ(calls(), "sbatch --parsable --partition=compute --array=1-3%2 " + scripts +
                         "shard.sh\n"
                         "sbatch --parsable --partition=compute --dependency=afterok:1 "
                         "--kill-on-invalid-dep=yes " +
                         scripts + "merge.sh\n");
  EXPECT_EQ(result.output, "room: 3 shards as job 1, the merge as job 2\n");
  EXPECT_THAT(read_file(scripts + "shard.sh"), HasSubstr("\n#SBATCH --partition=compute\n"));

  const std::string queue = "1 1 RUNNING None\n1 2 PENDING Resources\n2 N/A PENDING Dependency\n";
  EXPECT_THAT(cluster({"status", plan_}, {{"QUEUE", queue}}).output,
              HasSubstr("3 shards: 1 running, 1 waiting, 1 not run\n"));
  expect_one_line(cluster({"submit", plan_}, {{"QUEUE", queue}}), 1,
                  "room: is still in Slurm's queue as job 1; wait for it, or take it out");
}

TEST_F(Cluster, OnlyWhatIsNotDoneIsSubmittedAgain) {
  folder_.write("night/jobs/room/parts/2.film", "");
  ASSERT_EQ(cluster({"submit", plan_}).exit_code, 0);
  EXPECT_THAT(calls(), HasSubstr("--array=1,3 "));
  ASSERT_EQ(cluster({"submit", plan_, "--partition", "another"}).exit_code, 0);
  EXPECT_THAT(calls(), HasSubstr("--partition=another --array=1,3 "))
      << "the script that is there has none";
}

TEST_F(Cluster, NothingStaysSubmittedIfSlurmRefusesTheMerge) {
  expect_one_line(cluster({"submit", plan_}, {{"REFUSES_MERGES", "yes"}}), 1,
                  "sbatch: says: Invalid account");
  EXPECT_THAT(calls(), HasSubstr("scancel 1\n"));
}

TEST_F(Cluster, ADryRunSubmitsAndWritesNothing) {
  const ProgramResult result = cluster({"submit", plan_, "--dry-run"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("#!/bin/bash\n"));
  EXPECT_THAT(result.output,
              HasSubstr("# sbatch --dependency=afterok:<number of shard.sh> --kill-on"));
  EXPECT_FALSE(fs::exists(folder_ / "night"));
  EXPECT_THAT(calls(), IsEmpty());
}

TEST_F(Cluster, WithoutSlurmThereIsStillThisMachine) {
  fs::remove_all(folder_ / "slurm");
  expect_one_line(cluster({"submit", plan_}, {{"PATH", (folder_ / "slurm").string()}}), 1,
                  "run the plan on this machine with --local");
  expect_one_line(cluster({"status", plan_}), 1, "has no results of this plan; submit it first");
}

TEST_F(Cluster, StatusIsThereForPrograms) {
  folder_.write("night/jobs/room/parts/2.film", "");
  const ProgramResult result = cluster({"status", plan_, "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json.at(0).at("job"), "room");
  EXPECT_EQ(json.at(0).at("stages").at(0).at("parts").at(1).at("state"), "done");
  EXPECT_EQ(json.at(0).at("stages").at(1).at("stage"), "merge");
}

}  // namespace
}  // namespace foveola::test
