#include "renderer/cluster/job_status.h"

#include <gmock/gmock.h>

#include "renderer/base/error.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class JobInAFolder : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& content) {
    results_.write("jobs/image/" + name, content);
  }
  JobStatus status(const std::vector<QueuedTask>& tasks, bool runs_here = false) const {
    return status_of(job_, folder_, tasks, runs_here);
  }

  test::TemporaryFolder results_;
  ClusterJob job_{.name = "image",
                  .words = {"render"},
                  .command = *find_split_command({"render"}),
                  .shards = 5,
                  .output = "image.exr"};
  JobFolder folder_{results_.path(), job_};
};

TEST_F(JobInAFolder, IsSeenByItsPartsItsLogsAndTheQueue) {
  write("slurm.txt", "shard 12\nmerge 13\n");
  write("parts/1.film", "");
  write("logs/shard-1.log", "Part 1 is done.\n");
  write("logs/shard-2.log", "Part 2 of 5\nrendering   42 %  1 s left\n\n");
  write("logs/shard-3.log", "foveola: error: 3.film: is damaged\n");
  const JobStatus seen = status({{.job = 12, .number = 2, .state = "RUNNING", .reason = "None"},
                                 {.job = 12, .number = 4, .state = "PENDING", .reason = ""},
                                 {.job = 99, .number = 5, .state = "RUNNING", .reason = ""},
                                 {.job = 13, .number = 0, .state = "PENDING", .reason = ""}});
  EXPECT_TRUE(is_under_way(seen));
  EXPECT_TRUE(has_failed(seen));
  const std::string words = in_words(seen);
  EXPECT_THAT(words, HasSubstr("5 shards: 1 done, 1 running, 1 waiting, 1 failed, 1 not run\n"));
  EXPECT_THAT(words, HasSubstr("shard 2 running: rendering   42 %  1 s left\n"));
  EXPECT_THAT(words, HasSubstr("shard 3 failed: foveola: error: 3.film: is damaged\n"));
  EXPECT_THAT(words, HasSubstr("merging waits for the shards\n"));
}

TEST_F(JobInAFolder, SaysThatItIsNotMergedSinceSomethingFailed) {
  write("logs/shard-3.log", "foveola: error: 3.film: is damaged\n");
  EXPECT_FALSE(is_under_way(status({})));
  EXPECT_THAT(in_words(status({})), HasSubstr("not merged, since something failed"));
}

TEST_F(JobInAFolder, MayStillRunWhereAProcessOfThisMachineRunsThePlan) {
  write("logs/shard-3.log", "Part 3 of 5\n");
  EXPECT_TRUE(is_under_way(status({}, true)));
  EXPECT_FALSE(has_failed(status({}, true)));
}

TEST_F(JobInAFolder, IsDoneWhenItIsMerged) {
  results_.write("image.exr", "");
  write("logs/merge.log", "Merged\n");
  EXPECT_THAT(in_words(status({})), HasSubstr("merged: " + (results_ / "image.exr").string()));
}

TEST_F(JobInAFolder, KnowsWhatIsMissing) {
  write("parts/2.film", "");
  write("parts/5.film.new", "");
  EXPECT_THAT(folder_.missing(Stage::shards), ElementsAre(1, 3, 4, 5));
  EXPECT_THAT(folder_.missing(Stage::merge), ElementsAre(1));
  EXPECT_THAT(folder_.missing(Stage::prepare), testing::IsEmpty());
}

TEST_F(JobInAFolder, KeepsTheNumbersOfItsJobsInSlurm) {
  folder_.make();
  EXPECT_THAT(folder_.slurm_jobs(), testing::IsEmpty());
  folder_.keep_slurm_jobs({{Stage::shards, 12}, {Stage::merge, 13}});
  EXPECT_EQ(folder_.slurm_jobs(),
            (std::map<Stage, std::uint64_t>{{Stage::shards, 12}, {Stage::merge, 13}}));
}

TEST(Results, AreOfOnePlan) {
  const test::TemporaryFolder folder;
  begin_results(folder / "night", {.file = {}, .text = "one", .jobs = {}, .slurm_options = {}});
  begin_results(folder / "night", {.file = {}, .text = "one", .jobs = {}, .slurm_options = {}});
  EXPECT_THAT(
      [&] {
        begin_results(folder / "night",
                      {.file = {}, .text = "two", .jobs = {}, .slurm_options = {}});
      },
      testing::ThrowsMessage<Error>(HasSubstr("was begun with another plan")));
}

TEST(Results, AreOfOneProgram) {
  const test::TemporaryFolder folder;
  folder.write("night/jobs/program.txt", "Foveola 0.0.1");
  EXPECT_THAT(
      [&] {
        begin_results(folder / "night",
                      {.file = {}, .text = "one", .jobs = {}, .slurm_options = {}});
      },
      testing::ThrowsMessage<Error>(HasSubstr("was begun with another program than this")));
}

TEST(Results, AreLockedByWhoeverRunsThem) {
  const test::TemporaryFolder folder;
  begin_results(folder.path(), {.file = {}, .text = "one", .jobs = {}, .slurm_options = {}});
  EXPECT_FALSE(is_locked(folder.path()));
  {
    const ResultsLock lock(folder.path());
    EXPECT_TRUE(is_locked(folder.path()));
    EXPECT_THAT([&] { const ResultsLock second(folder.path()); },
                testing::ThrowsMessage<Error>(HasSubstr("another process runs")));
  }
  EXPECT_FALSE(is_locked(folder.path()));
}

TEST(LastLine, IsTheLastWithAnythingInIt) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(last_line(folder.write("log", "one\ntwo\n \n\n")), "two");
  EXPECT_EQ(last_line(folder.write("log", "")), "");
  EXPECT_EQ(last_line(folder / "none"), "");
  EXPECT_THAT(last_line(folder.write("log", std::string(100'000, 'a') + "\nlast")),
              testing::StrEq("last"));
}

}  // namespace
}  // namespace foveola
