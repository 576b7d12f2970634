
#include "study/record/read/study_records.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

using Backup = StudyFile;

TEST_F(Backup, OfAStudyThatIsBeingWrittenIsWhole) {
  StudyStore store(path_, thorough_protocol());
  run_thorough_session(store, "P01");
  store.back_up(folder_ / "copy.sqlite");
  run_thorough_session(store, "P02");
  EXPECT_THAT(verify_study(folder_ / "copy.sqlite").faults, IsEmpty());
  EXPECT_THAT(query_column(folder_ / "copy.sqlite", "SELECT participant FROM session"),
              ElementsAre("P01"));
  store.back_up(folder_ / "copy.sqlite");
  EXPECT_EQ(read_study(folder_ / "copy.sqlite").sessions.size(), 2U);
}

TEST_F(Backup, ThatCannotBeMadeLeavesNothing) {
  const StudyStore store(path_, small_protocol());
  const TemporaryFolder closed;
  EXPECT_THAT(refusal([&] { store.back_up(closed / "none/copy.sqlite"); }),
              HasSubstr("does not exist"));
  EXPECT_THAT(closed.entries(), IsEmpty());
}

TEST_F(Backup, LiesBesideTheStudyByItsTime) {
  {
    const StudyStore store(path_, small_protocol());
  }
  const fs::path first = back_up_study(path_);
  const fs::path second = back_up_study(path_);
  EXPECT_NE(first, second);
  EXPECT_EQ(first.parent_path(), folder_ / "study.sqlite.backups");
  EXPECT_THAT(first.filename().string(),
              MatchesRegex("20[0-9]{2}-[0-9]{2}-[0-9]{2}T[0-9-]+[.][0-9]+Z\\.sqlite"));
  EXPECT_TRUE(read_study(second).sessions.empty());
}

TEST_F(Backup, GoesToAnyFolderUnderTheStudysName) {
  write_thorough_session(path_, "P01");
  const TemporaryFolder disk;
  const fs::path copy = back_up_study_to(disk.path(), path_);
  EXPECT_EQ(disk.entries(), std::vector{copy.filename().string()});
  EXPECT_THAT(copy.filename().string(),
              MatchesRegex("study[.]20[0-9-]+T[0-9-]+[.][0-9]+Z\\.sqlite"));
  EXPECT_THAT(verify_study(copy).faults, IsEmpty());
  EXPECT_EQ(read_study(copy).sessions.size(), 1U);
  EXPECT_EQ(folder_.entries(), std::vector<std::string>{"study.sqlite"}) << "and nowhere else";
}

TEST_F(Backup, KnowsTheDiskOfTheStudy) {
  EXPECT_TRUE(is_on_disk_of(folder_.path(), path_));
  EXPECT_FALSE(is_on_disk_of("/proc", path_));
  EXPECT_FALSE(is_on_disk_of(folder_ / "none", path_));
}

}  // namespace
}  // namespace foveola::study
