#include "study/record/controller_lock.h"

#include <array>
#include <csignal>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "small_study.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(ControllerLock, TheSecondIsToldWhoTheFirstIs) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  const StudyStore first(path, small_protocol());
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size());
  EXPECT_THAT(refusal([&] { const StudyStore second(path, small_protocol()); }),
              AllOf(StartsWith(path.string() + ": is being written by record_test "),
                    HasSubstr(fmt::format(", process {} of ", ::getpid())),
                    HasSubstr(fmt::format(" on {}, since 20", host.data())),
                    HasSubstr("Z; let that end, or take another file")));
}

TEST(ControllerLock, IsOfTheFileUnderWhateverName) {
  const TemporaryFolder folder;
  const StudyStore first(folder / "study.sqlite", small_protocol());
  fs::create_symlink(folder / "study.sqlite", folder / "link.sqlite");
  EXPECT_THAT(refusal([&] { const StudyStore second(folder / "link.sqlite", small_protocol()); }),
              HasSubstr("is being written by"));
}

TEST(ControllerLock, LeavesNothingBehind) {
  const TemporaryFolder folder;
  { const ControllerLock lock(folder / "study.sqlite"); }
  EXPECT_TRUE(folder.content().empty());
  { const ControllerLock again(folder / "study.sqlite"); }
}

TEST(ControllerLock, OfAKilledProgramIsGoneWithIt) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(::pipe(pipe_ends.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const ControllerLock lock(path);
    [[maybe_unused]] const ssize_t written = ::write(pipe_ends[1], "!", 1);
    ::pause();
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(pipe_ends[0], &byte, 1), 1);
  EXPECT_THAT(refusal([&] { const ControllerLock second(path); }),
              HasSubstr(fmt::format("process {} of", child)));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(folder.content().size(), 1U);
  { const ControllerLock next(path); }
  EXPECT_TRUE(folder.content().empty());
  ::close(pipe_ends[0]);
  ::close(pipe_ends[1]);
}

TEST(ControllerLock, ReadersAreNotKeptOut) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  StudyStore store(path, small_protocol());
  store.begin_session(facts_of("P01"), small_plan());
  EXPECT_EQ(query(path, "SELECT participant FROM session"), "P01");
}

}  // namespace
}  // namespace foveola::study
