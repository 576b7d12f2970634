// Other programs at a study's file, and other code of this one, while a session writes it.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/read/data_quality_records.h"
#include "study/record/read/recorded_gaze.h"
#include "study/record/read/recorded_session.h"
#include "study/record/read/study_records.h"
#include "study/record/setup/same_scenes.h"
#include "tests/file_locks.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

bool is_locked_by_us(const fs::path& path) { return test::is_locked_by(::getpid(), path); }

/// A session at its first trial.
class Neighbours : public testing::Test {
 protected:
  Neighbours() { session_.begin(); }

  void write_note(const std::string& text = "a note") { session_.note(text); }
  std::size_t events_in(const fs::path& file) const {
    return std::stoul(query(file, "SELECT count(*) FROM event"));
  }
  /// The file in which the record was saved.
  fs::path saved() const {
    for (const std::string& name : folder_.entries()) {
      if (name.starts_with("study.saved-")) {
        return folder_ / name;
      }
    }
    return {};
  }

  const TemporaryFolder folder_;
  const fs::path path_ = folder_ / "study.sqlite";
  const fs::path log_ = folder_ / "study.sqlite-wal";
  std::optional<StudyStore> store_{std::in_place, path_, small_protocol()};
  PlayedSession session_{*store_, facts_of("P01"), small_plan()};
};

TEST_F(Neighbours, WhoeverReadsItInThisProcessLeavesTheLocks) {
  ASSERT_TRUE(is_locked_by_us(path_));
  const fs::path link = folder_ / "link.sqlite";
  fs::create_symlink(path_, link);
  const std::map<std::string, std::function<void()>> readers = {
      {"require_same_scenes", [&] { require_same_scenes(path_, facts_of("P01").scenes); }},
      {"read_study", [&] { read_study(path_); }},
      {"read_data_quality", [&] { read_data_quality(path_); }},
      {"read_session", [&] { read_session(path_, "P01"); }},
      {"verify_study", [&] { verify_study(path_); }},
      {"back_up_study", [&] { back_up_study(path_); }},
      {"StudyStore::back_up", [&] { store_->back_up(folder_ / "copy.sqlite"); }},
      {"merge_studies", [&] { merge_studies({path_, link}, folder_ / "merged.sqlite"); }}};
  for (const auto& [name, read] : readers) {
    try {
      read();
    } catch (const Error& error) {
      ADD_FAILURE() << name << ": " << error.what();
    }
    EXPECT_TRUE(is_locked_by_us(path_)) << name;
  }
}

// By another program, which would fold the log into the file and remove it if it were the last.
TEST_F(Neighbours, NothingIsLostToAnotherProgramThatReads) {
  for (int time = 0; time < 3; ++time) {
    const pid_t reader = ::fork();
    if (reader == 0) {
      ::execlp("sqlite3", "sqlite3", path_.c_str(), "SELECT count(*) FROM event", nullptr);
      ::_exit(127);
    }
    int status = -1;
    ::waitpid(reader, &status, 0);
    if (WEXITSTATUS(status) == 127) {
      GTEST_SKIP() << "there is no sqlite3";
    }
    EXPECT_EQ(status, 0);
    read_study(path_);
    write_note();
  }
  EXPECT_EQ(events_in(path_), 5U);
}

TEST_F(Neighbours, ALogThatIsRemovedIsSavedAndNothingMoreIsRecorded) {
  write_note();
  fs::remove(log_);
  const std::string lost = refusal([&] { write_note("the last"); });
  EXPECT_THAT(lost,
              AllOf(StartsWith(path_.string() + ": its log (-wal) was removed, replaced or cut"),
                    HasSubstr(saved().string())));
  EXPECT_EQ(refusal([&] { write_note(); }), lost) << "from now on";
  store_.reset();
  EXPECT_EQ(events_in(saved()), 4U);
  EXPECT_THAT(verify_study(saved()).faults, IsEmpty());
  StudyStore again(saved(), small_protocol());
  EXPECT_EQ(again.events_of(session_.id()).size(), 4U);
}

TEST_F(Neighbours, ALogThatIsReplacedByAnOlderCopyIsSeen) {
  const fs::path older = folder_ / "older";
  fs::copy_file(log_, older);
  write_note();
  fs::rename(older, log_);
  EXPECT_THAT(refusal([&] { write_note(); }), HasSubstr(saved().string()));
  store_.reset();
  EXPECT_EQ(events_in(saved()), 4U);
}

TEST_F(Neighbours, ALogThatIsCutOffIsSeenWhereverItIsCut) {
  const std::uintmax_t frame = 24 + std::stoul(query(path_, "PRAGMA page_size"));
  for (const std::uintmax_t cut : {std::uintmax_t{1}, frame, 2 * frame + 100}) {
    SCOPED_TRACE(cut);
    const TemporaryFolder folder;
    const fs::path path = folder / "study.sqlite";
    const fs::path log = path.string() + "-wal";
    StudyStore store(path, small_protocol());
    PlayedSession session = begun_session(store);
    fs::resize_file(log, fs::file_size(log) - cut);
    EXPECT_THAT(refusal([&] { session.choose_and_start(ms(100)); }), HasSubstr("or cut off"));
    EXPECT_THAT(verify_study(store.record_file()).faults, IsEmpty());
    EXPECT_EQ(query(store.record_file(), "SELECT count(*) FROM event"), "2") << "what it had";
  }
}

// Any program may fold the log into the file, and then begins it anew.
TEST_F(Neighbours, ALogThatIsFoldedInByAnotherConnectionIsNoLoss) {
  for (const char* how : {"PASSIVE", "FULL", "RESTART", "TRUNCATE"}) {
    write_note();
    SQLite::Database other(path_, SQLite::OPEN_READWRITE);
    other.execAndGet(fmt::format("PRAGMA wal_checkpoint({})", how));
    write_note();
  }
  EXPECT_EQ(events_in(path_), 10U);
}

TEST_F(Neighbours, ALargeLogIsFoldedInFromTimeToTime) {
  for (int i = 0; i < 40; ++i) {
    write_note(std::string(200'000, 'n'));
  }
  constexpr std::uintmax_t thousand_pages = 4'152'000;
  EXPECT_LT(fs::file_size(log_), 2 * thousand_pages);
  EXPECT_EQ(events_in(path_), 42U);
}

}  // namespace
}  // namespace foveola::study
