#include "renderer/cluster/cluster_plan.h"

#include <gmock/gmock.h>

#include "renderer/base/error.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* night = R"(slurm_options = ["--account=vision"]

[[job]]
name = "cohort"
command = "study simulate koskela2018 --participants 1000 --people 'my people.toml' --predicted"
shards = 16
prepare_shards = 4
output = "study.sqlite"
time_limit = "2-12:00:00"
cores = 8
memory = "4G"

[[job]]
name = "reference"
command = "foveola render arcade --spp 100000 --split seeds"
shards = 40
output = "reference.exr"
)";

class ClusterPlanFile : public testing::Test {
 protected:
  ClusterPlan plan(const std::string& text) {
    return read_cluster_plan(folder_.write("night.toml", text));
  }

  /// Expects that the plan with `to` in the place of `from` is refused with these words.
  void expect_refused(const std::string& from, const std::string& to, const std::string& says) {
    std::string text = night;
    const std::size_t at = text.find(from);
    ASSERT_NE(at, text.npos) << from;
    text.replace(at, from.size(), to);
    EXPECT_THAT([&] { plan(text); }, testing::ThrowsMessage<Error>(
                                         testing::AllOf(HasSubstr("night.toml"), HasSubstr(says))))
        << to;
  }

  test::TemporaryFolder folder_;
};

TEST_F(ClusterPlanFile, SaysWhatIsToBeDone) {
  const ClusterPlan read = plan(night);
  EXPECT_EQ(read.folder(), folder_.path());
  EXPECT_THAT(read.slurm_options, ElementsAre("--account=vision"));
  ASSERT_EQ(read.jobs.size(), 2);
  const ClusterJob& cohort = read.jobs.front();
  EXPECT_EQ(cohort.name, "cohort");
  EXPECT_THAT(cohort.words, ElementsAre("study", "simulate", "koskela2018", "--participants",
                                        "1000", "--people", "my people.toml", "--predicted"));
  EXPECT_EQ(cohort.command.merge_words, "study merge");
  EXPECT_EQ(cohort.shards, 16);
  EXPECT_EQ(cohort.prepare_shards, 4);
  EXPECT_EQ(cohort.output, "study.sqlite");
  EXPECT_EQ(cohort.time_limit, "2-12:00:00");
  EXPECT_EQ(cohort.cores, 8);
  EXPECT_EQ(cohort.memory, "4G");
  const ClusterJob& reference = read.jobs.back();
  EXPECT_EQ(reference.words.front(), "render");
  EXPECT_EQ(reference.prepare_shards, 0);
  EXPECT_THAT(reference.time_limit, IsEmpty());
}

TEST_F(ClusterPlanFile, KnowsAllCommandsThatCanBeSplit) {
  for (const SplitCommand& command : split_commands()) {
    const std::string extension =
        command.result_extensions.empty() ? "" : std::string(command.result_extensions.front());
    const ClusterPlan read =
        plan("[[job]]\nname = \"a\"\nshards = 2\ncommand = \"" + std::string(command.words) +
             " x\"\noutput = \"result" + extension + "\"\n");
    EXPECT_EQ(read.jobs.front().command.words, command.words);
  }
}

TEST_F(ClusterPlanFile, RefusesWhatCannotBeSplit) {
  expect_refused("study simulate", "study run",
                 "no command that can be split; begin it with study "
                 "simulate, render");
  expect_refused("render arcade", "render arcade --shard 1/2", "--shard is given by the plan");
  expect_refused("render arcade", "render arcade -o a.film", "-o is given by the plan");
  expect_refused("render arcade", "render arcade --output=a.film", "--output=a.film is given");
  expect_refused("--predicted", "--db a.sqlite", "--db is given by the plan");
  expect_refused("'my people.toml'", "'my people.toml", "a quotation mark ' is not closed");
  expect_refused("command = \"foveola render", "command = \"\" # ", "command");
}

TEST_F(ClusterPlanFile, RefusesNamesThatWouldLeaveItsFolder) {
  expect_refused("\"cohort\"", "\"../cohort\"", "this is no plain name");
  expect_refused("\"cohort\"", "\"two words\"", "this is no plain name");
  expect_refused("\"study.sqlite\"", "\"/tmp/study.sqlite\"", "no plain name of a file");
  expect_refused("\"study.sqlite\"", "\"..sqlite\"", "no plain name of a file");
  expect_refused("\"study.sqlite\"", "\"jobs\"", "or that of the jobs");
  expect_refused("\"reference.exr\"", "\"reference.jpg\"", "end the name in .exr or .png");
  expect_refused("\"reference\"", "\"cohort\"", "another job has this, too");
}

TEST_F(ClusterPlanFile, RefusesWhatSlurmWouldNotRead) {
  expect_refused("\"2-12:00:00\"", "\"two days\"", "write \"08:00:00\"");
  expect_refused("\"4G\"", "\"4G --nodes=9\"", "write \"4G\"");
  expect_refused("--account=vision", "account", "this is no option of sbatch");
  expect_refused("--account=vision", "--account=vision\\nrm -rf", "this is no option of sbatch");
  expect_refused("shards = 16", "shards = 0", "shards");
  expect_refused("shards = 40", "shards = 40\nprepare_shards = 2", "render has no caches to fill");
  expect_refused("cores = 8", "core = 8", "core");
  EXPECT_THAT([&] { plan(""); }, testing::ThrowsMessage<Error>(HasSubstr("has no job")));
}

}  // namespace
}  // namespace foveola
