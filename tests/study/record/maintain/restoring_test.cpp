#include <fstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/stat.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/read/study_records.h"
#include "study/record/sqlite/controller_lock.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

const char* const date = "20[0-9-]+T[0-9-]+[.][0-9]+Z";

void spoil(const fs::path& study) {
  std::fstream file(study, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(2 * 4096);
  file << std::string(4096, 'x');
}

/// A study with P01, a backup of it, and then P02.
class DamagedStudy : public StudyFile {
 protected:
  DamagedStudy() {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01");
    store.back_up(backup_);
    run_thorough_session(store, "P02");
  }

  std::size_t events_of(const std::string& participant) const {
    return std::stoul(query(path_,
                            "SELECT count(*) FROM event JOIN session ON session.id = session"
                            " WHERE participant = '" +
                                participant + "'"));
  }

  void expect_backup_in_place() const {
    EXPECT_THAT(query_column(path_, "SELECT participant FROM session"), ElementsAre("P01"));
    EXPECT_THAT(verify_study(path_).faults, IsEmpty());
    StudyStore goes_on(path_, thorough_protocol());
    run_thorough_session(goes_on, "P03");
  }

  const fs::path backup_ = new_backup(path_);
};

TEST_F(DamagedStudy, IsMovedAsideWithItsLogAndItsJournal) {
  spoil(path_);
  const std::map<std::string, std::string> former = {
      {"", read_file(path_)}, {"-journal", "a journal"}, {"-wal", "a log"}, {"-shm", "an index"}};
  for (const auto& [suffix, bytes] : former) {
    write_file(path_.string() + suffix, bytes);
  }
  const Restored restored = restore_study(path_, std::nullopt);
  EXPECT_EQ(restored.copy, backup_);
  ASSERT_EQ(restored.moved_aside.size(), 4U);
  const std::string aside = restored.moved_aside.back();
  EXPECT_THAT(aside, MatchesRegex(path_.string() + ".damaged-" + date));
  for (const auto& [suffix, bytes] : former) {
    EXPECT_TRUE(read_file(aside + suffix) == bytes) << suffix;
    EXPECT_EQ(fs::exists(path_.string() + suffix), suffix.empty()) << suffix;
  }
  EXPECT_EQ(restored.missing, std::nullopt) << "nobody can read it";
  expect_backup_in_place();
}

// A log that stays is the worst of it: SQLite plays it into whatever file has its name.
TEST_F(DamagedStudy, LeavesNoLogThatChangesTheCopy) {
  {
    SQLite::Database killed(path_, SQLite::OPEN_READWRITE);
    killed.exec(
        "PRAGMA journal_mode = WAL; PRAGMA wal_autocheckpoint = 0; DROP TRIGGER event_is_fixed");
    killed.exec("UPDATE event SET utc = 'now'");
    fs::copy_file(path_.string() + "-wal", folder_ / "log");
  }
  fs::rename(folder_ / "log", path_.string() + "-wal");
  EXPECT_THAT(restore_study(path_, std::nullopt).missing, Optional(SizeIs(1)));
  expect_backup_in_place();
}

TEST_F(DamagedStudy, ThatCanBeReadSaysWhatTheCopyLacks) {
  tamper(path_, "UPDATE event SET utc = '2016-11-21T09:30:00.000Z' WHERE sequence = 3");
  ASSERT_FALSE(verify_study(path_).faults.empty());
  const std::size_t events = events_of("P02");
  const Restored restored = restore_study(path_, std::nullopt);
  ASSERT_TRUE(restored.missing);
  ASSERT_EQ(restored.missing->size(), 1U);
  EXPECT_EQ(restored.missing->front().participant, "P02");
  EXPECT_EQ(restored.missing->front().missing, events);
  EXPECT_EQ(restored.missing->front().events, events);
  expect_backup_in_place();
}

TEST_F(DamagedStudy, TakesTheNewestBackupThatIsSound) {
  const fs::path later = backup_folder(path_) / "2999-01-01T00-00-00.000Z.sqlite";
  fs::copy_file(backup_, later);
  spoil(later);
  spoil(path_);
  EXPECT_EQ(restore_study(path_, std::nullopt).copy, backup_);
  expect_backup_in_place();
}

TEST_F(DamagedStudy, ThatIsGoneIsRestoredToo) {
  fs::remove(path_);
  EXPECT_THAT(restore_study(path_, std::nullopt).moved_aside, IsEmpty());
  expect_backup_in_place();
}

TEST_F(DamagedStudy, KeepsItsAccess) {
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  restore_study(path_, std::nullopt);
  struct stat status{};
  ASSERT_EQ(::stat(path_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(DamagedStudy, StaysWhereNoCopyIsSound) {
  spoil(path_);
  spoil(backup_);
  const auto before = folder_.content();
  EXPECT_THAT(refusal([&] { restore_study(path_, std::nullopt); }),
              HasSubstr("has no sound backup in " + backup_folder(path_).string()));
  EXPECT_THAT(refusal([&] { restore_study(path_, backup_); }), StartsWith(backup_.string() + ": "));
  EXPECT_THAT(refusal([&] { restore_study(path_, path_); }), HasSubstr("is the study itself"));
  EXPECT_EQ(folder_.content(), before);
}

TEST_F(DamagedStudy, IsNotTakenFromAProgramThatWritesIt) {
  const ControllerLock writer(path_);
  const auto before = folder_.content();
  EXPECT_THAT(refusal([&] { restore_study(path_, std::nullopt); }),
              HasSubstr("is being written by "));
  EXPECT_EQ(folder_.content(), before);
}

using StudyOfAKilledProgram = StudyFile;

// With the file alone, what the log holds would be lost.
TEST_F(StudyOfAKilledProgram, BelongsToTheLogThatHoldsItsCommits) {
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01");
    EXPECT_THAT(verify_study(path_).warnings, IsEmpty()) << "it is being written";
    for (const char* suffix : {"", "-wal"}) {
      fs::copy_file(path_.string() + suffix, folder_ / ("killed.sqlite" + std::string(suffix)));
    }
  }
  EXPECT_THAT(verify_study(path_).warnings, IsEmpty());
  const Verification killed = verify_study(folder_ / "killed.sqlite");
  EXPECT_THAT(killed.faults, IsEmpty());
  EXPECT_THAT(killed.warnings, ElementsAre(FieldsAre(
                                   "", StartsWith("its log, killed.sqlite-wal, holds commits that "
                                                  "are not in the file yet: keep and copy both"))));
}

}  // namespace
}  // namespace foveola::study
