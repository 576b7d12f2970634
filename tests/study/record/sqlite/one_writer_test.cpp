// A study's file has one writer at a time, whatever other names the file has or gets.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "study/record/read/study_records.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

TEST(OneWriter, WhileOneWriterIsAtWorkNoSecondComesByAnotherName) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  {
    StudyStore store(path, small_protocol());
    PlayedSession session = begun_session(store);
    const fs::path other = folder / "other.sqlite";
    fs::create_hard_link(path, other);
    EXPECT_THAT(refusal([&] { const StudyStore second(other, small_protocol()); }),
                AllOf(StartsWith(other.string() + ": "), HasSubstr("has 2 names")));
    EXPECT_THAT(refusal([&] { read_study(other); }), HasSubstr("has 2 names"))
        << "it would miss the log beside the first name";
    fs::remove(other);
    session.run_trial(ms(100), ms(2000), ms(3000), 2);
  }
  EXPECT_EQ(read_study(path).trials.size(), 4U);
}

// By a program of its own, as whoever starts a second one is.
TEST(OneWriter, NoSecondProgramWritesByAnotherName) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  StudyStore store(path, small_protocol());
  PlayedSession session = begun_session(store);
  fs::create_hard_link(path, folder / "hard.sqlite");
  fs::create_symlink(path, folder / "soft.sqlite");
  for (const auto& [name, words] : {std::pair("hard.sqlite", "has 2 names"),
                                    std::pair("soft.sqlite", "is being written by ")}) {
    const pid_t child = ::fork();
    if (child == 0) {
      std::string message;
      try {
        const StudyStore second(folder / name, small_protocol());
      } catch (const Error& error) {
        message = error.what();
      }
      ::_exit(message.find(words) != std::string::npos ? 0 : 1);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0) << name;
  }
  fs::remove(folder / "hard.sqlite");
  session.run_trial(ms(100), ms(2000), ms(3000), 2);
  EXPECT_EQ(store.events_of(session.id()).size(), 8U);
}

TEST(OneWriter, WriterStopsWhenItsFileIsMoved) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  const fs::path moved = folder / "moved.sqlite";
  std::string lost;
  {
    StudyStore store(path, small_protocol());
    PlayedSession session = begun_session(store);
    fs::rename(path, moved);
    const auto go_on = [&] { session.note("a note"); };
    lost = refusal(go_on);
    EXPECT_THAT(lost, StartsWith(path.string() + ": was moved"));
    fs::rename(moved, path);
    EXPECT_EQ(refusal(go_on), lost);
    EXPECT_NE(store.record_file(), path);
    EXPECT_THAT(lost, HasSubstr(store.record_file().string()));
    EXPECT_EQ(query(store.record_file(), "SELECT count(*) FROM event"), "2");
    EXPECT_THAT(verify_study(store.record_file()).faults, IsEmpty());
  }
  EXPECT_EQ(query(path, "SELECT count(*) FROM event"), "2");
  EXPECT_THAT(verify_study(path).faults, IsEmpty());
}

}  // namespace
}  // namespace foveola::study
