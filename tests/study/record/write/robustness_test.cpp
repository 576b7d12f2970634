// What a study's file goes through besides kills: a full disk, another writer, a clock that was
// set back.
#include <atomic>
#include <thread>

#include <SQLiteCpp/SQLiteCpp.h>
#include <sched.h>
#include <sys/mount.h>

#include "study/record/log/event_log.h"
#include "study/record/sqlite/database.h"
#include "study/record/write/session_rows.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

/// A folder on a disk of a megabyte of its own, which only this process sees.
class SmallDisk {
 public:
  explicit SmallDisk(fs::path folder) : folder_(std::move(folder)) {
    is_mounted_ = ::unshare(CLONE_NEWNS) == 0 &&
                  ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                  ::mount("small", folder_.c_str(), "tmpfs", 0, "size=1m") == 0;
  }
  ~SmallDisk() {
    if (is_mounted_) {
      ::umount(folder_.c_str());
    }
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  bool is_mounted() const { return is_mounted_; }

 private:
  fs::path folder_;
  bool is_mounted_;
};

TEST(Robustness, AFullDiskIsNamedAndLosesNothing) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder.path());
  if (!disk.is_mounted()) {
    GTEST_SKIP() << "only root may mount a small disk";
  }
  const fs::path path = folder / "study.sqlite";
  StudyStore store(path, small_protocol());
  PlayedSession session = begun_session(store);
  std::size_t written = 0;
  const std::string message = refusal([&] {
    for (; written < 10'000; ++written) {
      session.note(std::string(1000, 'n'));
    }
  });
  EXPECT_THAT(message,
              AllOf(StartsWith(path.string()), HasSubstr("what was acknowledged is safe")));
  EXPECT_GT(written, 50U);
  EXPECT_EQ(store.events_of(session.id()).size(), 2U + written);
  EXPECT_THAT(verify_study(path).faults, IsEmpty());
}

/// Of two megabytes.
void write_large_study(const fs::path& path, const std::string& participant) {
  StudyStore store(path, small_protocol());
  PlayedSession session(store, facts_of(participant), small_plan());
  session.begin();
  for (int i = 0; i < 2; ++i) {
    session.note(std::string(1 << 20, 'n'));
  }
}

TEST(Robustness, AFullDiskIsThatOfTheFileThatIsWritten) {
  const TemporaryFolder folder;
  const TemporaryFolder small;
  const SmallDisk disk(small.path());
  if (!disk.is_mounted()) {
    GTEST_SKIP() << "only root may mount a small disk";
  }
  write_large_study(folder / "a.sqlite", "P01");
  write_large_study(folder / "b.sqlite", "P02");
  const fs::path merged = small / "all.sqlite";
  EXPECT_THAT(refusal([&] { merge_studies({folder / "a.sqlite", folder / "b.sqlite"}, merged); }),
              StartsWith(merged.string() + ": the disk is full"));
  const fs::path backups = folder / "a.sqlite.backups";
  fs::create_directory_symlink(small.path(), backups);
  EXPECT_THAT(refusal([&] { back_up_study(folder / "a.sqlite"); }),
              MatchesRegex(backups.string() + "/20[^/]*Z.sqlite: the disk is full.*"));
  EXPECT_THAT(small.entries(), IsEmpty());
}

TEST(Robustness, AClockThatWasSetBackChangesNoTimes) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  create_study(path, small_protocol());
  {
    SQLite::Database database = open_study_to_write(path);
    PreparedStatements statements(database);
    const Agenda agenda = agenda_of(small_protocol(), small_plan());
    const Procedure procedure = procedure_of(small_protocol(), small_plan());
    const std::int64_t session = insert_session(
        database, facts_of("P01"),
        {.uuid = random_uuid(), .started_utc = "2026-11-21T09:30:00.000Z"}, small_plan(), agenda);
    const std::vector<LoggedEvent> events = {
        {ms(0), SessionStarted{}, "2026-11-21T09:30:00.100Z"},
        {ms(10), QuestionnaireAnswered{"background", {}}, "2026-11-21T09:30:00.200Z"},
        {ms(20), ObjectChosen{"vase"}, "2026-11-21T09:29:30.000Z"},
        {ms(30), TrialStarted{}, "2026-11-21T03:00:00.010Z"},
        {ms(40), FirstFramePresented{ms(40)}, "2016-01-01T00:00:00.000Z"},
        {ms(90), Marked{ms(90)}, "2016-01-01T00:00:00.050Z"}};
    SessionState state;
    for (const LoggedEvent& logged : events) {
      const Transition next = step(procedure, state, logged.event).value();
      append_event(statements, session, procedure, logged, state, next.state);
      state = next.state;
    }
  }
  EXPECT_EQ(query(path, "SELECT time_ns FROM mark"), "50000000");
  const Verification found = verify_study(path);
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_THAT(
      found.warnings,
      ElementsAre(FieldsAre("P01", StartsWith("the computer's clock was set back by 6 h 29 m "
                                              "before event 4 (trial_started): ")),
                  FieldsAre("P01", HasSubstr("by 3977 days before event 5 "))))
      << "half a minute is what a clock's correction takes";
}

TEST(Robustness, AnotherWritersTurnIsWaitedFor) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  StudyStore store(path, small_protocol());
  SQLite::Database stranger(path, SQLite::OPEN_READWRITE);
  stranger.exec("BEGIN IMMEDIATE");
  std::atomic<bool> is_recorded = false;
  std::thread recorder([&] {
    store.begin_session(facts_of("P01"), small_plan());
    is_recorded = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(is_recorded);
  stranger.exec("COMMIT");
  recorder.join();
  EXPECT_EQ(query(path, "SELECT participant FROM session"), "P01");
}

TEST(Robustness, AWriterWhoNeverEndsIsNamed) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  StudyStore store(path, small_protocol());
  SQLite::Database stranger(path, SQLite::OPEN_READWRITE);
  stranger.exec("BEGIN IMMEDIATE");
  EXPECT_THAT(refusal([&] { store.begin_session(facts_of("P01"), small_plan()); }),
              AllOf(StartsWith(path.string()), HasSubstr("is in use by another program")));
  stranger.exec("COMMIT");
  EXPECT_EQ(query(path, "SELECT count(*) FROM session"), "0");
  store.begin_session(facts_of("P01"), small_plan());
}

}  // namespace
}  // namespace foveola::study
