#include "study/record/sqlite/controller_lock.h"

#include <array>
#include <csignal>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

using ControllerLocks = StudyFile;

TEST_F(ControllerLocks, TheSecondLearnsWhoTheFirstIs) {
  const StudyStore first(path_, small_protocol());
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size());
  EXPECT_THAT(refusal([&] { const StudyStore second(path_, small_protocol()); }),
              AllOf(StartsWith(path_.string() + ": is being written by record_test "),
                    HasSubstr(fmt::format(", process {} of ", ::getpid())),
                    HasSubstr(fmt::format(" on {}, since 20", host.data())),
                    HasSubstr("Z; let that end, or take another file")));
}

TEST_F(ControllerLocks, IsOfTheFileUnderWhateverName) {
  const StudyStore first(path_, small_protocol());
  fs::create_symlink(path_, folder_ / "link.sqlite");
  EXPECT_THAT(refusal([&] { const StudyStore second(folder_ / "link.sqlite", small_protocol()); }),
              HasSubstr("is being written by"));
}

TEST_F(ControllerLocks, LeavesNothingBehind) {
  {
    const ControllerLock lock(path_);
  }
  EXPECT_TRUE(folder_.content().empty());
  {
    const ControllerLock again(path_);
  }
}

TEST_F(ControllerLocks, OfAKilledProgramIsGoneWithIt) {
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(::pipe(pipe_ends.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const ControllerLock lock(path_);
    [[maybe_unused]] const ssize_t written = ::write(pipe_ends[1], "!", 1);
    ::pause();
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(pipe_ends[0], &byte, 1), 1);
  EXPECT_THAT(refusal([&] { const ControllerLock second(path_); }),
              HasSubstr(fmt::format("process {} of", child)));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(folder_.content().size(), 1U);
  {
    const ControllerLock next(path_);
  }
  EXPECT_TRUE(folder_.content().empty());
  ::close(pipe_ends[0]);
  ::close(pipe_ends[1]);
}

TEST_F(ControllerLocks, ReadersAreNotKeptOut) {
  StudyStore store(path_, small_protocol());
  store.begin_session(facts_of("P01"), small_plan());
  EXPECT_EQ(query(path_, "SELECT participant FROM session"), "P01");
}

}  // namespace
}  // namespace foveola::study
