#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "small_study.h"
#include "study/record/maintenance.h"
#include "study/record/study_records.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Backup, OfAStudyThatIsBeingWrittenIsWhole) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  StudyStore store(path, thorough_protocol());
  run_thorough_session(store, "P01");
  store.back_up(folder / "copy.sqlite");
  run_thorough_session(store, "P02");
  EXPECT_THAT(verify_study(folder / "copy.sqlite").faults, IsEmpty());
  EXPECT_THAT(query_column(folder / "copy.sqlite", "SELECT participant FROM session"),
              ElementsAre("P01"));
  store.back_up(folder / "copy.sqlite");
  EXPECT_EQ(read_study(folder / "copy.sqlite").sessions.size(), 2U);
}

TEST(Backup, CanBeGoneOnWith) {
  const TemporaryFolder folder;
  {
    StudyStore store(folder / "study.sqlite", thorough_protocol());
    run_thorough_session(store, "P01");
    store.back_up(folder / "copy.sqlite");
  }
  StudyStore restored(folder / "copy.sqlite", thorough_protocol());
  run_thorough_session(restored, "P02");
}

TEST(Backup, ThatCannotBeMadeLeavesNothing) {
  const TemporaryFolder folder;
  const StudyStore store(folder / "study.sqlite", small_protocol());
  const TemporaryFolder closed;
  EXPECT_THAT(refusal([&] { store.back_up(closed / "none/copy.sqlite"); }),
              HasSubstr("does not exist"));
  EXPECT_THAT(closed.entries(), IsEmpty());
}

TEST(Backup, LiesBesideTheStudyByItsTime) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  { const StudyStore store(path, small_protocol()); }
  const fs::path first = back_up_study(path);
  const fs::path second = back_up_study(path);
  EXPECT_NE(first, second);
  EXPECT_EQ(first.parent_path(), folder / "study.sqlite.backups");
  EXPECT_THAT(first.filename().string(),
              testing::MatchesRegex("20[0-9]{2}-[0-9]{2}-[0-9]{2}T[0-9:.]+Z\\.sqlite"));
  EXPECT_TRUE(read_study(second).sessions.empty());
}

}  // namespace
}  // namespace foveola::study
