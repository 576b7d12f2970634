// Files of strangers, in and beside a study's: nothing of them runs, and no number of theirs is
// trusted.
#include <csignal>
#include <fstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/read/data_quality_records.h"
#include "study/record/read/recorded_gaze.h"
#include "study/record/read/recorded_session.h"
#include "study/record/read/study_records.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

/// A study with a whole session.
class StrangersFiles : public StudyFile {
 protected:
  StrangersFiles() {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01");
  }

  std::vector<std::string> faults() const {
    std::vector<std::string> texts;
    for (const RecordFault& fault : verify_study(path_).faults) {
      texts.push_back(fault.what);
    }
    return texts;
  }
};

/// A journal by which SQLite would write zeros over the second page.
std::string journal_of_zeros() {
  const auto number = [](unsigned value) {
    return std::string{static_cast<char>(value >> 24U), static_cast<char>(value >> 16U),
                       static_cast<char>(value >> 8U), static_cast<char>(value)};
  };
  std::string journal("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
  journal += number(1) + number(0) + number(10) + number(512) + number(4096);
  journal.resize(512);
  return journal + number(2) + std::string(4096, '\0') + number(0);
}

TEST_F(StrangersFiles, AJournalIsNotPlayedIntoTheFile) {
  const std::string before = read_file(path_);
  folder_.write("study.sqlite-journal", journal_of_zeros());
  EXPECT_THAT(faults(), IsEmpty());
  EXPECT_THAT(
      verify_study(path_).warnings,
      ElementsAre(FieldsAre(
          "", StartsWith(path_.string() + "-journal: is not a journal that Foveola wrote"))));
  EXPECT_EQ(read_study(path_).sessions.size(), 1U);
  EXPECT_THAT(refusal([&] { const StudyStore store(path_, thorough_protocol()); }),
              AllOf(StartsWith(path_.string() + "-journal: is not a journal that Foveola wrote"),
                    HasSubstr("move it to another folder")));
  EXPECT_TRUE(read_file(path_) == before);
}

// It holds the first page as it is, and only the number of pages is another.
TEST_F(StrangersFiles, AJournalThatWouldCutTheFileOffIsRefused) {
  const std::string before = read_file(path_);
  std::string journal = journal_of_zeros();
  journal.replace(16, 4, std::string("\0\0\0\1", 4));
  journal.replace(512, 4, std::string("\0\0\0\1", 4));
  journal.replace(516, 4096, before.substr(0, 4096));
  folder_.write("study.sqlite-journal", journal);
  EXPECT_THAT(refusal([&] { const StudyStore store(path_, thorough_protocol()); }),
              HasSubstr("is not a journal that Foveola wrote"));
  EXPECT_TRUE(read_file(path_) == before);
}

TEST_F(StrangersFiles, ALockThatIsALinkIsNotFollowed) {
  const fs::path other = folder_.write("other", "somebody's");
  fs::create_symlink(other, path_.string() + ".controller");
  EXPECT_THAT(refusal([&] { const StudyStore store(path_, thorough_protocol()); }),
              StartsWith(path_.string() + ".controller: cannot be opened"));
  EXPECT_EQ(read_file(other), "somebody's");
}

TEST_F(StrangersFiles, NoTriggerHidesUnderANameOfSQLites) {
  tamper(path_,
         "PRAGMA writable_schema = ON; INSERT INTO sqlite_schema VALUES ('trigger', 'sqlite_stat1',"
         " 'event', 0, 'CREATE TRIGGER sqlite_stat1 AFTER INSERT ON event BEGIN DELETE FROM"
         " gaze_chunk; END')");
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("has the trigger sqlite_stat1 on event")));
  EXPECT_THAT(refusal([&] { const StudyStore store(path_, thorough_protocol()); }),
              HasSubstr("has the trigger sqlite_stat1 on event"));
}

TEST_F(StrangersFiles, StatisticsHoldNumbersAlone) {
  tamper(path_, "ANALYZE");
  EXPECT_THAT(faults(), IsEmpty());
  tamper(path_, "INSERT INTO sqlite_stat1 VALUES ('event', NULL, 'a message')");
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("sqlite_stat1 holds")));
}

TEST_F(StrangersFiles, NumbersThatFoveolaNeverWritesAreFaultsAndNoOverflow) {
  const std::string whole = read_file(path_);
  for (const char* change :
       {"UPDATE frame_chunk SET frame_count = 4611686018427387904",
        "UPDATE frame_chunk SET frame_count = -1",
        "UPDATE frame_chunk SET first_frame = 9223372036854775807",
        "UPDATE gaze_chunk SET sample_count = 4611686018427387904",
        "UPDATE gaze_chunk SET attempt = 4294967297",
        "UPDATE event SET payload = '{\"time_ns\":-9223372036854775808}'"
        " WHERE type = 'first_frame_presented'",
        "UPDATE event SET payload = '{\"time_ns\":9223372036854775807}' WHERE type = 'marked'",
        "UPDATE planned_trial SET scene_position = 65536",
        "UPDATE session SET design_row = 4294967296", "UPDATE event SET time_ns = 1 << 62",
        "UPDATE film_hash SET frame = 9223372036854775807",
        "UPDATE event SET payload = '{\"time_ns\":1e300}' WHERE type = 'marked'"}) {
    SCOPED_TRACE(change);
    folder_.write("study.sqlite", whole);
    tamper(path_, std::string("PRAGMA foreign_keys = OFF; PRAGMA ignore_check_constraints = ON; ") +
                      change);
    EXPECT_FALSE(faults().empty());
    for (const std::function<void()>& read : std::vector<std::function<void()>>{
             [&] { read_study(path_); }, [&] { read_data_quality(path_); },
             [&] { visit_gaze(path_, [](const AttemptGaze&) {}); }}) {
      try {
        read();
      } catch (const Error&) {
      }
    }
  }
}

// What they say would be an index, a count or a loop of another program.
TEST_F(StrangersFiles, NumbersOutOfTheStudyAreRefusedByWhatTheyAre) {
  const std::string whole = read_file(path_);
  const std::function<void()> study = [&] { read_study(path_); };
  const std::function<void()> session = [&] { read_session(path_, "P01"); };
  struct Case {
    const char* change;
    std::function<void()> read;
    const char* refusal;
  };
  for (const auto& [change, read, text] : std::vector<Case>{
           {"planned_trial SET method_position = 3", study,
            "method_position has the value 3, of 3 that there are"},
           {"planned_trial SET scene_position = 2", study,
            "scene_position has the value 2, of 2 that there are"},
           {"planned_step SET trial = 6 WHERE trial = 5", session,
            "trial has the value 6, of 6 that there are"},
           {"planned_step SET times = -2147483648 WHERE kind = 'validation'", session,
            "times has the value -2147483648, which is out of range"},
           {"session SET seed = '18446744073709551616'", session,
            "its record says \"18446744073709551616\""},
           {R"(event SET payload = replace(payload, '"value":', '"value":9e999,"x":'))"
            " WHERE type = 'rated'",
            study, "value is not finite"},
           {R"(event SET payload = replace(payload, ':31.0', ':-9e999'))"
            " WHERE type = 'questionnaire_answered'",
            study, "number is not finite"}}) {
    SCOPED_TRACE(change);
    folder_.write("study.sqlite", whole);
    tamper(path_, std::string("PRAGMA foreign_keys = OFF; PRAGMA ignore_check_constraints = ON;"
                              " UPDATE OR IGNORE ") +
                      change);
    EXPECT_THAT(refusal(read), HasSubstr(text));
  }
}

TEST_F(StrangersFiles, AStudyOnADiskThatCannotBeWrittenIsReadWithItsLog) {
  if (::unshare(CLONE_NEWNS) != 0 ||
      ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) {
    GTEST_SKIP() << "only root may mount a disk";
  }
  const TemporaryFolder folder;
  ASSERT_EQ(::mount("disk", folder.path().c_str(), "tmpfs", 0, "size=10m"), 0);
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P02");
    for (const char* suffix : {"", "-wal"}) {
      fs::copy_file(path_.string() + suffix, folder / ("study.sqlite" + std::string(suffix)));
    }
  }
  ASSERT_EQ(::mount("disk", folder.path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr), 0);
  EXPECT_EQ(read_study(folder / "study.sqlite").sessions.size(), 2U);
  EXPECT_THAT(verify_study(folder / "study.sqlite").faults, IsEmpty());
  ::umount(folder.path().c_str());
}

// By the mode, and by the group where its folder is a group's.
TEST_F(StrangersFiles, WhatIsNewIsItsUsersAlone) {
  const auto mode_of = [](const fs::path& file) {
    struct stat status{};
    ::stat(file.c_str(), &status);
    return status.st_mode & 07777U;
  };
  StudyStore store(path_, thorough_protocol());
  run_thorough_session(store, "P02");
  for (const char* suffix : {"", "-wal", "-shm", ".controller"}) {
    EXPECT_EQ(mode_of(path_.string() + suffix), 0600U) << suffix;
  }
  EXPECT_EQ(mode_of(back_up_study(path_)), 0600U);
  merge_studies({path_}, folder_ / "merged.sqlite");
  EXPECT_EQ(mode_of(folder_ / "merged.sqlite"), 0600U);
  const TemporaryFolder shared;
  ::chmod(shared.path().c_str(), 02770);
  merge_studies({path_}, shared / "merged.sqlite");
  EXPECT_EQ(mode_of(shared / "merged.sqlite"), 0660U);
}

TEST_F(StrangersFiles, WhatIsRewrittenKeepsItsMode) {
  write_thorough_session(path_, "P02");
  ::chmod(path_.c_str(), 0640);
  forget_participant(path_, "P02");
  EXPECT_EQ(fs::status(path_).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

}  // namespace
}  // namespace foveola::study
