// The scripts of shards run on this machine, with a program that does what a test wants of it.
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <sys/wait.h>

#include "renderer/base/files.h"
#include "renderer/base/programs.h"
#include "renderer/cluster/job_scripts.h"
#include "renderer/cluster/local_run.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A program that writes its part, with how often it was started: `$part` is its file, `$shard` its
/// number. What `behaves` says comes before.
std::string program_that(const std::string& behaves) {
  return R"(#!/bin/bash
while [ $# -gt 0 ]; do
  case $1 in
    --output | --db) part=$2 ;;
    --shard) shard=${2%/*} ;;
  esac
  shift
done
echo x >>"$part"
)" + behaves +
         "\nwc -l <\"$part\" >\"$part.count\"\nmv \"$part.count\" \"$part\"\n";
}

/// For `behaves`: waits until the script waits for the program, and so has set its traps.
const std::string once_awaited =
    "until grep -q '^State:.S' /proc/$PPID/status; do sleep 0.01; done\n";

class Shards : public testing::Test {
 protected:
  void begin(const std::vector<std::string>& words, const std::string& behaves) {
    job_.command = *find_split_command(words);
    job_.words = words;
    folder_.emplace(results_ / "night", job_);
    folder_->make();
    const std::filesystem::path program = results_.write("program", program_that(behaves));
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const ScriptSetting setting{.program = program,
                                .plan_folder = results_.path(),
                                .plan_name = "night.toml",
                                .slurm_options = {},
                                .at_once = 0};
    write_file(folder_->script(Stage::shards), job_script(Stage::shards, setting, job_, *folder_));
  }

  std::vector<ScriptEnd> run(const std::vector<std::int64_t>& numbers) {
    return run_here(*folder_, Stage::shards, numbers, 2,
                    [this](std::size_t count) { ended_ = count; }, {});
  }

  std::string part(std::int64_t number) const {
    return read_file(folder_->done(Stage::shards, number));
  }
  std::string log(std::int64_t number) const {
    return read_file(folder_->log(Stage::shards, number));
  }

  test::TemporaryFolder results_;
  ClusterJob job_{.name = "night", .words = {}, .shards = 3, .output = "result"};
  std::optional<JobFolder> folder_;
  std::size_t ended_ = 0;
};

TEST_F(Shards, RunUntilAllPartsAreThere) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"render"}, std::vector<std::string>{"study", "simulate"}}) {
    begin(words, "");
    EXPECT_THAT(run({1, 2, 3}), IsEmpty());
    EXPECT_EQ(ended_, 3U);
    EXPECT_THAT(folder_->missing(Stage::shards), IsEmpty());
    EXPECT_EQ(part(3), "1\n");
    std::filesystem::remove_all(results_ / "night");
  }
}

TEST_F(Shards, ThatAreDoneAreNotRunAgain) {
  begin({"render"}, "");
  run({2});
  EXPECT_THAT(run({2}), IsEmpty());
  EXPECT_EQ(part(2), "1\n");
  EXPECT_THAT(log(2), HasSubstr("Part 2 of 3 is done already."));
}

TEST_F(Shards, GoOnWhereTheyWereKilled) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"render"}, std::vector<std::string>{"study", "simulate"}}) {
    begin(words, "[ \"$shard\" != 2 ] || [ $(wc -l <\"$part\") -gt 2 ] || kill -9 $$");
    EXPECT_THAT(run({1, 2, 3}), IsEmpty());
    EXPECT_EQ(part(1), "1\n");
    EXPECT_EQ(part(2), "3\n") << log(2);
    EXPECT_THAT(log(2), HasSubstr("Part 2 is to go on: it ended with exit code 137"));
    std::filesystem::remove_all(results_ / "night");
  }
}

TEST_F(Shards, ThatAreKilledAgainAndAgainFail) {
  begin({"render"}, "[ \"$shard\" != 2 ] || kill -9 $$");
  const std::vector<ScriptEnd> failed = run({1, 2, 3});
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed.front().number, 2);
  EXPECT_EQ(WEXITSTATUS(failed.front().status), 137);
  EXPECT_THAT(folder_->missing(Stage::shards), ElementsAre(2));
}

TEST_F(Shards, FailWithTheProgram) {
  begin({"study", "simulate"}, "if [ \"$shard\" = 3 ]; then echo 'error: no' >&2; exit 1; fi");
  const std::vector<ScriptEnd> failed = run({1, 2, 3});
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed.front().number, 3);
  EXPECT_EQ(WEXITSTATUS(failed.front().status), 1);
  EXPECT_EQ(last_line(folder_->log(Stage::shards, 3)), "error: no");
}

TEST_F(Shards, KeepWhatTheyHaveWhenTheirTimeIsUp) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"render"}, std::vector<std::string>{"study", "simulate"}}) {
    begin(words,
          "if [ $(wc -l <\"$part\") = 1 ]; then\n"
          "  trap 'exit 130' TERM\n" +
              once_awaited +
              "  kill -USR1 $PPID\n"
              "  while :; do sleep 0.1; done\n"
              "fi");
    EXPECT_THAT(run({1}), IsEmpty());
    EXPECT_THAT(log(1), HasSubstr("Part 1 is to go on: its time was up"));
    EXPECT_EQ(part(1), "2\n");
    std::filesystem::remove_all(results_ / "night");
  }
}

TEST_F(Shards, ThatComeNoFurtherInTheirTimeFail) {
  begin({"bench", "statistics"},
        "rm \"$part\"\n"
        "trap 'exit 130' TERM\n" +
            once_awaited +
            "kill -USR1 $PPID\n"
            "while :; do sleep 0.1; done");
  ASSERT_EQ(run({1}).size(), 1U);
  EXPECT_THAT(last_line(folder_->log(Stage::shards, 1)),
              HasSubstr("came no further in its time: give it more"));
}

TEST_F(Shards, KeepWhatTheyHaveWhenTheyAreStopped) {
  begin({"study", "simulate"},
        "if [ $(wc -l <\"$part\") = 1 ]; then\n"
        "  trap 'exit 130' TERM\n" +
            once_awaited +
            "  touch begun\n"
            "  while :; do sleep 0.1; done\n"
            "fi");
  std::stop_source stop;
  std::jthread stopper([&](const std::stop_token& over) {
    while (!std::filesystem::exists(results_ / "begun") && !over.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    stop.request_stop();
  });
  run_here(*folder_, Stage::shards, {1, 2, 3}, 1, [](std::size_t) {}, stop.get_token());
  EXPECT_THAT(folder_->missing(Stage::shards), ElementsAre(1, 2, 3));
  EXPECT_FALSE(std::filesystem::exists(folder_->log(Stage::shards, 2)));
  EXPECT_EQ(last_line(folder_->log(Stage::shards, 1)), "Part 1 was stopped.");
  EXPECT_THAT(run({1}), IsEmpty());
  EXPECT_EQ(part(1), "2\n");
}

}  // namespace
}  // namespace foveola
