#include "study/record/sqlite/database.h"

#include <fstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/stat.h>

#include "renderer/base/error.h"
#include "study/record/read/study_records.h"
#include "study/record/sqlite/temporary_database.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

void write_bytes(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

void overwrite(const fs::path& path, std::int64_t offset, const std::string& bytes) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(offset);
  file << bytes;
}

void run_sql(const fs::path& path, const std::string& sql) {
  SQLite::Database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(sql);
}

/// A study with one completed trial in one session.
void write_small_study(const fs::path& path) {
  StudyStore store(path, small_protocol());
  PlayedSession session = begun_session(store);
  session.run_trial(ms(100), ms(2000), ms(3000), 2);
}

/// A user who may not do everything, for the length of a scope.
class OrdinaryUser {
 public:
  OrdinaryUser() {
    if (original_ == 0) {
      constexpr uid_t nobody = 65534;
      EXPECT_EQ(::setresuid(nobody, nobody, original_), 0);
    }
  }
  ~OrdinaryUser() { EXPECT_EQ(::setresuid(original_, original_, original_), 0); }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;

 private:
  uid_t original_ = ::geteuid();
};

/// A file that is no study, and the words that must say so.
struct BadFile {
  std::string name;
  std::function<void(const fs::path&)> make;
  std::string message;
};

std::ostream& operator<<(std::ostream& out, const BadFile& file) { return out << file.name; }

class BadFiles : public testing::TestWithParam<BadFile> {};

TEST_P(BadFiles, AreRefusedByReaderAndWriterAndLeftAsTheyWere) {
  const TemporaryFolder folder;
  const fs::path path = folder / "bad.sqlite";
  GetParam().make(path);
  const auto before = folder.content();
  const auto message = AllOf(StartsWith(path.string() + ": "), HasSubstr(GetParam().message));

  EXPECT_THAT(refusal([&] { read_study(path); }), message);
  EXPECT_EQ(folder.content(), before);
  EXPECT_THAT(refusal([&] { const StudyStore store(path, small_protocol()); }), message);
  EXPECT_EQ(folder.content(), before);
}

using Change = std::function<void(const fs::path&)>;

/// A small study that was changed like this.
Change spoilt(const Change& change) {
  return [change](const fs::path& path) {
    write_small_study(path);
    change(path);
  };
}

Change with_bytes(std::int64_t offset, const std::string& bytes) {
  return spoilt([offset, bytes](const fs::path& path) { overwrite(path, offset, bytes); });
}

Change after_sql(const std::string& sql) {
  return spoilt([sql](const fs::path& path) { run_sql(path, sql); });
}

Change of_size(const std::function<std::uintmax_t(std::uintmax_t)>& size) {
  return spoilt([size](const fs::path& path) { fs::resize_file(path, size(fs::file_size(path))); });
}

std::vector<BadFile> bad_files() {
  return {
      {"Text", [](const fs::path& path) { write_bytes(path, std::string(5000, 'x')); },
       "is no database"},
      {"ShortText", [](const fs::path& path) { write_bytes(path, "x"); }, "is no study of Foveola"},
      {"Empty", [](const fs::path& path) { write_bytes(path, ""); }, "is no study of Foveola"},
      {"Folder", [](const fs::path& path) { fs::create_directory(path); }, "is "},
      {"Pipe", [](const fs::path& path) { ::mkfifo(path.c_str(), 0600); }, "is not a regular file"},
      {"OtherDatabase", [](const fs::path& path) { run_sql(path, "CREATE TABLE t (x)"); },
       "is no study of Foveola"},
      {"OtherApplication", with_bytes(68, "Abcd"), "is no study of Foveola"},
      {"SecondName", spoilt([](const fs::path& path) {
         fs::create_hard_link(path, path.parent_path() / "other.sqlite");
       }),
       "has 2 names (hard links)"},
      {"NewerSchema", with_bytes(63, "\x06"),
       "has schema 6, and this program knows only 4 and 5; use a newer Foveola"},
      {"OlderSchema", with_bytes(63, "\x03"),
       "has schema 3, and this program knows only 4 and 5; go on with the Foveola that began it, "
       "or begin a new study"},
      {"Truncated", of_size([](std::uintmax_t size) { return size / 2; }), "is damaged"},
      {"OverwrittenPages", with_bytes(8192, std::string(8192, '\x5a')), "is damaged"},
      {"GuardRemoved", after_sql("DROP TRIGGER event_stays"),
       "its trigger event_stays is missing or was changed"},
      {"ByteMissing", of_size([](std::uintmax_t size) { return size - 1; }), "is damaged (has "},
      {"PageAppended", of_size([](std::uintmax_t size) { return size + 4096; }),
       "is damaged (has "},
      {"EndlessView",
       after_sql("DROP VIEW trial_result; CREATE VIEW trial_result AS WITH RECURSIVE n(i) AS"
                 " (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i FROM n ORDER BY i"),
       "its view trial_result is missing or was changed"},
  };
}

INSTANTIATE_TEST_SUITE_P(Database, BadFiles, testing::ValuesIn(bad_files()),
                         [](const auto& parameter) { return parameter.param.name; });

using Database = StudyFile;

TEST_F(Database, WriterRefusesWhatCouldChangeWhatItWrites) {
  write_small_study(path_);
  const std::string whole = folder_.content().at("study.sqlite");
  for (const auto& [sql, words] :
       {std::pair(
            "CREATE TRIGGER faster AFTER INSERT ON event BEGIN SELECT 1; END",
            "has the trigger faster on event, which is not Foveola's and could change what is "
            "recorded; remove it (DROP TRIGGER in sqlite3)"),
        std::pair("CREATE UNIQUE INDEX one ON session (kind)",
                  "has the index one on session, which is not Foveola's")}) {
    folder_.write("study.sqlite", whole);
    run_sql(path_, sql);
    const auto before = folder_.content();
    EXPECT_THAT(refusal([&] { const StudyStore store(path_, small_protocol()); }),
                AllOf(StartsWith(path_.string()), HasSubstr(words)));
    EXPECT_EQ(folder_.content(), before);
    EXPECT_EQ(read_study(path_).sessions.size(), 1U) << "it can still be read";
  }
  folder_.write("study.sqlite", whole);
  run_sql(path_,
          "CREATE VIEW marks AS SELECT * FROM mark;"
          " CREATE TABLE remark (session INTEGER UNIQUE, text TEXT); ANALYZE");
  const StudyStore store(path_, small_protocol());
}

TEST_F(Database, ReaderRefusesWhatIsNotThereAndMakesNothing) {
  EXPECT_THAT(refusal([&] { read_study(folder_ / "none.sqlite"); }), HasSubstr("no such file"));
  EXPECT_TRUE(folder_.content().empty());
}

TEST_F(Database, WriterRefusesFoldersThatAreMissingOrClosed) {
  EXPECT_THAT(refusal([&] { const StudyStore store(folder_ / "none/a.sqlite", small_protocol()); }),
              HasSubstr("does not exist"));
  fs::permissions(folder_.path(), fs::perms(0555));
  const OrdinaryUser user;
  EXPECT_THAT(refusal([&] { const StudyStore store(folder_ / "a.sqlite", small_protocol()); }),
              HasSubstr("cannot be written"));
  EXPECT_TRUE(folder_.content().empty());
}

TEST_F(Database, WriterRefusesAFileItMayOnlyRead) {
  write_small_study(path_);
  fs::permissions(path_, fs::perms(0444));
  fs::permissions(folder_.path(), fs::perms(0777));
  const auto before = folder_.content();
  {
    const OrdinaryUser user;
    EXPECT_THAT(refusal([&] { const StudyStore store(path_, small_protocol()); }),
                HasSubstr("cannot be written"));
  }
  EXPECT_EQ(folder_.content(), before);
}

TEST_F(Database, WriterRefusesAnotherProtocol) {
  write_small_study(path_);
  const auto before = folder_.content();
  for (const auto& [protocol, words] :
       {std::pair(other_protocol(), "with another protocol than other.toml"),
        std::pair(protocol_with_another_file(), "with another file as a.png (SHA-256 eeee"),
        std::pair(protocol_with_another_tracker(), "with another tracker than camera, as its")}) {
    EXPECT_THAT(refusal([&] { const StudyStore store(path_, protocol); }),
                AllOf(StartsWith(path_.string()), HasSubstr(words)));
    EXPECT_EQ(folder_.content(), before);
  }
}

// What a crash leaves: the file, and beside it a log that holds the newest commits.
TEST_F(Database, LogOfACrashIsReadAndSurvivesARefusal) {
  const TemporaryFolder crashed;
  const fs::path path = crashed / "study.sqlite";
  {
    StudyStore store(folder_ / "study.sqlite", small_protocol());
    PlayedSession session = begun_session(store);
    fs::copy(folder_ / "study.sqlite", path);
    fs::copy(folder_ / "study.sqlite-wal", crashed / "study.sqlite-wal");
  }
  const auto before = crashed.content();
  refusal([&] { const StudyStore store(path, other_protocol()); });
  EXPECT_EQ(crashed.content().at("study.sqlite"), before.at("study.sqlite"));
  EXPECT_EQ(crashed.content().at("study.sqlite-wal"), before.at("study.sqlite-wal"));

  EXPECT_EQ(read_study(path).sessions.at(0).state, "choosing_object");
  {
    const StudyStore recovered(path, small_protocol());
  }
  EXPECT_THAT(crashed.content(), SizeIs(1));
  EXPECT_EQ(query(path, "SELECT count(*) FROM event"), "2");
}

// What a loss of power leaves while the log is folded in: a page written in half, and a journal
// whose content never came to the disk. SQLite reads the page from the log and ignores the journal.
TEST_F(Database, HalfAPageUnderALogAndAJournalWithoutContentAreNoDamage) {
  const StudyStore store(path_, small_protocol());
  const TemporaryFolder left;
  const fs::path path = left / "study.sqlite";
  fs::copy(path_, path);
  fs::copy(path_.string() + "-wal", path.string() + "-wal");
  overwrite(path, static_cast<std::int64_t>(fs::file_size(path)), "half a page");
  write_bytes(path.string() + "-journal", std::string(512, '\0'));

  EXPECT_THAT(read_study(path).sessions, IsEmpty());
  EXPECT_THAT(StudyStore(path, small_protocol()).sessions(), IsEmpty());
}

TEST_F(Database, ReadsInAFolderThatCannotBeWritten) {
  write_small_study(path_);
  fs::permissions(path_, fs::perms(0644));
  fs::permissions(folder_.path(), fs::perms(0555));
  {
    const OrdinaryUser user;
    EXPECT_EQ(read_study(path_).trials.size(), 4U);
  }
  EXPECT_THAT(folder_.content(), SizeIs(1));
}

TEST_F(Database, PathsMayHoldWhatIsSpecialInAUri) {
  const fs::path path = folder_ / "50%20? a#b&immutable=0.sqlite";
  write_small_study(path);
  EXPECT_EQ(read_study(path).sessions.size(), 1U);
  EXPECT_EQ(folder_.content().count("50%20? a#b&immutable=0.sqlite"), 1U);
  EXPECT_EQ(folder_.content().size(), 1U);
}

TEST_F(Database, WritersConnectionIsDurable) {
  create_study(path_, small_protocol());
  SQLite::Database database = open_study_to_write(path_);
  EXPECT_EQ(database.execAndGet("PRAGMA journal_mode").getString(), "wal");
  constexpr int full = 2;
  EXPECT_EQ(database.execAndGet("PRAGMA synchronous").getInt(), full);
  EXPECT_EQ(database.execAndGet("PRAGMA foreign_keys").getInt(), 1);
  EXPECT_GT(database.execAndGet("PRAGMA busy_timeout").getInt(), 0);
}

TEST_F(Database, NewStudyNeverTakesTheNameOfAnother) {
  write_small_study(path_);
  const auto before = folder_.content();
  create_study(path_, small_protocol());
  EXPECT_EQ(folder_.content(), before);
}

TEST_F(Database, HalfMadeStudyOfAKilledProgramIsNoObstacle) {
  const fs::path half = folder_ / ".study.sqlite.0123456789abcdef.partial";
  write_bytes(half, "half");
  write_bytes(half.string() + "-wal", "half");
  create_study(folder_ / "study.sqlite", small_protocol());
  EXPECT_EQ(folder_.content().size(), 1U);
  EXPECT_TRUE(read_study(folder_ / "study.sqlite").sessions.empty());
}

// Another machine's process has a number that means nothing here.
TEST_F(Database, WhatARunningProgramMakesStays) {
  const TemporaryDatabase another(folder_ / "other.sqlite");
  write_bytes(another.path().string() + "-journal", "in use");
  write_bytes(folder_ / ".notes.partial", "of another kind");
  create_study(folder_ / "study.sqlite", small_protocol());
  EXPECT_EQ(folder_.content().size(), 4U);
}

}  // namespace
}  // namespace foveola::study
