// What a researcher does with studies' files between sessions: status, verify, backup, merge and
// forget, and what the program refuses.
#include <algorithm>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "renderer/base/files/files.h"
#include "tests/end_to_end/hall.h"
#include "tests/end_to_end/running_program.h"
#include "tests/end_to_end/study_rows.h"
#include "tests/matchers.h"
#include "tests/study/record/bytes_from_hex.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

/// Two sites' files of the study of the hall, as the program wrote them.
struct Sites {
  Sites() {
    north = simulated("north.sqlite", "2", "0");
    south = simulated("south.sqlite", "3", "1");
  }

  std::string simulated(const std::string& name, const std::string& participants,
                        const std::string& seed) const {
    succeeded(hall.run({"study", "simulate", "hall", "--db", (hall.folder / name).string(),
                        "--participants", participants, "--seed", seed}));
    return read_file(hall.folder / name);
  }

  Hall hall;
  std::string north;  ///< a study with P001 and P002
  std::string south;  ///< a study with P001, P002 and P003, other people
};

class StudyFile : public testing::Test {
 protected:
  static const Sites& sites() {
    static const Sites made;  // once for all tests
    return made;
  }

  static ProgramResult study(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "study");
    return run_foveola(arguments);
  }

  /// The program with the rights of somebody who may not write wherever root may.
  static ProgramResult study_without_privilege(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {FOVEOLA_PROGRAM, "study"});
    if (::geteuid() == 0) {
      arguments.insert(arguments.begin(), {"setpriv", "--bounding-set=-dac_override"});
    }
    return run_program(arguments);
  }

  std::string path_of(const std::string& name) const { return (folder_ / name).string(); }

  /// All bytes of all files, whatever they are.
  std::string everything() const {
    std::string bytes;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      bytes += entry.is_regular_file() ? read_file(entry.path()) : "";
    }
    return bytes;
  }

  TemporaryFolder folder_;
  const std::string north_ = folder_.write("north.sqlite", sites().north);
  const std::string south_ = folder_.write("south.sqlite", sites().south);
};

/// A query of a copy: SQLite leaves files beside the one that it reads.
Rows rows_of_copy(const fs::path& study, const std::string& sql) {
  const TemporaryFolder folder;
  return all_rows_of(folder.write("copy.sqlite", read_file(study)), sql);
}

/// Each value of each row that a study keeps of a participant, by table.
std::map<std::string, Rows> content_of(const fs::path& study, const std::string& participant) {
  const TemporaryFolder folder;
  const fs::path copy = folder.write("copy.sqlite", read_file(study));
  const std::string id =
      value_of(copy, fmt::format("SELECT id FROM session WHERE participant = '{}'", participant));
  const auto rows = [&](const std::string& table, const std::string& key) {
    const std::string values =
        value_of(copy, fmt::format("SELECT group_concat('quote(' || name || ')')"
                                   " FROM pragma_table_info('{}') WHERE name <> '{}'",
                                   table, key));
    return all_rows_of(
        copy, fmt::format("SELECT {} FROM {} WHERE {} = {} ORDER BY 1, 2", values, table, key, id));
  };
  std::map<std::string, Rows> content = {{"session", rows("session", "id")}};
  for (const std::string& table :
       all_rows_of(copy,
                   "SELECT objects.name FROM sqlite_schema AS objects"
                   " JOIN pragma_table_info(objects.name) AS columns"
                   " WHERE objects.type = 'table' AND columns.name = 'session'")) {
    content[table] = rows(table, "session");
  }
  EXPECT_FALSE(content.at("event").empty() || content.at("frame_chunk").empty());
  return content;
}

TEST_F(StudyFile, VerifyFindsNothingInWhatWasWritten) {
  const ProgramResult verified = succeeded(study({"verify", south_}));
  EXPECT_THAT(verified.output, MatchesRegex("sessions +3\nevents +[0-9]+\nchunks +[0-9]+\n"
                                            "faults +0\n"));
}

TEST_F(StudyFile, VerifyNamesTheChunkInWhichAByteWasFlipped) {
  const std::string data = study::bytes_from_hex(
      rows_of_copy(north_, "SELECT hex(substr(data, 1, 32)) FROM frame_chunk WHERE session = 2")
          .at(0));
  std::string flipped = sites().north;
  const std::size_t place = flipped.find(data);
  ASSERT_NE(place, std::string::npos);
  flipped.at(place + 20) = static_cast<char>(~flipped.at(place + 20));
  folder_.write("north.sqlite", flipped);
  const ProgramResult verified = study({"verify", north_});
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_THAT(verified.output,
              HasSubstr("P002: trial 0, attempt 1: frame_chunk from 0 on is missing or not what"
                        " was written\n"));
  EXPECT_EQ(std::count(verified.errors.begin(), verified.errors.end(), '\n'), 1);
  EXPECT_THAT(verified.errors, HasSubstr("north.sqlite: failed its verification"));
}

TEST_F(StudyFile, BackupIsTheStudyOnceMore) {
  const ProgramResult backup = succeeded(study({"backup", north_}));
  const std::string copy = backup.output.substr(0, backup.output.find('\n'));
  EXPECT_EQ(fs::path(copy).parent_path(), folder_ / "north.sqlite.backups");
  for (const char* participant : {"P001", "P002"}) {
    EXPECT_EQ(content_of(copy, participant), content_of(north_, participant));
  }
}

TEST_F(StudyFile, RestorePutsACopyInThePlaceOfADamagedFile) {
  const std::string good = read_file(north_);
  const std::string copy = path_of("copy.sqlite");
  fs::copy_file(north_, copy);
  fs::resize_file(north_, good.size() / 2);
  expect_one_line(study({"status", north_}), 1,
                  "put a copy in the study's place by foveola study restore");
  expect_one_line(study({"restore", north_}), 1, "north.sqlite: has no sound backup in ");
  const ProgramResult restored = succeeded(study({"restore", north_, "--from", copy}));
  EXPECT_THAT(restored.output,
              MatchesRegex(fmt::format("{0}: restored from {1}\n"
                                       "{0}[.]damaged-[^:]*: the former file\n.*\n",
                                       north_, copy)));
  EXPECT_EQ(content_of(north_, "P002"), content_of(copy, "P002"));
  EXPECT_EQ(study({"verify", north_}).exit_code, 0);
}

TEST_F(StudyFile, MergePutsTwoSitesTogether) {
  const std::string all = path_of("all.sqlite");
  expect_one_line(study({"merge", north_, south_, "-o", all}), 1,
                  "south.sqlite: its participant P001 is another person");
  for (const char* participant : {"P001", "P002"}) {
    EXPECT_EQ(study({"forget", south_, participant, "--yes"}).exit_code, 0);
  }
  EXPECT_EQ(study({"merge", north_, south_, "-o", all}).output,
            all + ": 3 sessions, 0 of them in several files\n");
  EXPECT_EQ(content_of(all, "P001"), content_of(north_, "P001"));
  EXPECT_EQ(content_of(all, "P002"), content_of(north_, "P002"));
  EXPECT_EQ(content_of(all, "P003"), content_of(south_, "P003"));

  const std::string before = everything();
  expect_one_line(study({"merge", north_, south_, "-o", all}), 1, "all.sqlite: exists already");
  EXPECT_EQ(everything(), before);

  const std::string again = path_of("again.sqlite");
  EXPECT_EQ(study({"merge", all, north_, north_, "-o", again}).output,
            again + ": 3 sessions, 2 of them in several files: P001, P002\n");
  EXPECT_EQ(rows_of_copy(again, "SELECT participant, uuid FROM session ORDER BY 1"),
            rows_of_copy(all, "SELECT participant, uuid FROM session ORDER BY 1"));
}

TEST_F(StudyFile, ForgetLeavesNoByteOfOneAndAllOfTheOther) {
  fs::remove(south_);
  const std::string copy = study({"backup", north_}).output;
  const std::string backup = copy.substr(0, copy.find('\n'));
  const auto other = content_of(north_, "P001");
  const Rows traces =
      rows_of_copy(north_,
                   "SELECT uuid FROM session WHERE participant = 'P002'"
                   " UNION ALL SELECT hash FROM event JOIN session ON session.id = session"
                   " WHERE participant = 'P002' AND sequence <"
                   " (SELECT max(sequence) FROM event WHERE session = session.id)");
  const std::string before = everything();
  expect_one_line(study({"forget", north_, "P002"}), 2, "--yes");
  expect_one_line(study({"forget", north_, "P009", "--yes"}), 1, "has no participant P009");
  EXPECT_EQ(everything(), before);
  for (const std::string& trace : traces) {
    EXPECT_THAT(before, HasSubstr(trace));
  }

  const ProgramResult forgotten = succeeded(study({"forget", north_, "P002", "--yes"}));
  EXPECT_THAT(forgotten.output,
              AllOf(StartsWith(north_ + ": participant P002 was erased from 2 files\n"),
                    HasSubstr("The disk may hold deleted data")));
  const std::string after = everything();
  for (const std::string& trace : traces) {
    EXPECT_EQ(after.find(trace), std::string::npos) << trace;
  }
  for (const std::string& file : {north_, backup}) {
    EXPECT_THAT(rows_of_copy(file, "SELECT participant FROM session"), ElementsAre("P001"));
    EXPECT_EQ(content_of(file, "P001"), other);
  }
  EXPECT_EQ(study({"verify", north_}).exit_code, 0);
}

TEST_F(StudyFile, VerifyComparesWithWhatStatusPrinted) {
  const std::string head = path_of("head.txt");
  for (const std::vector<std::string>& form :
       {std::vector<std::string>{"status", north_, "--json"}, {"status", north_}}) {
    folder_.write("head.txt", study(form).output);
    EXPECT_EQ(study({"verify", north_, "--head", head}).exit_code, 0);
    const ProgramResult other = study({"verify", south_, "--head", head});
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_THAT(other.output, HasSubstr(" is missing\n"));
  }
  ASSERT_EQ(study({"forget", north_, "P002", "--yes"}).exit_code, 0) << "a head stays";
  const ProgramResult forgotten = succeeded(study({"verify", north_, "--head", head}));
  EXPECT_THAT(forgotten.output, HasSubstr(" was forgotten\n"));
  folder_.write("head.txt", study({"status", north_}).output);
  succeeded(study({"verify", north_, "--head", head}));
  EXPECT_THAT(study({"verify", south_, "--head", head}).output,
              HasSubstr(", of a session that was forgotten, is missing\n"));
  expect_one_line(study({"verify", north_, "--head", folder_.write("empty", "no head")}), 1,
                  "empty: has no line of a session");
}

/// Each command on a study's file, which it reads or goes on with; output: where one is to be made.
std::vector<std::vector<std::string>> commands_on(const std::string& file,
                                                  const std::string& output) {
  return {{"status", file},
          {"verify", file},
          {"backup", file},
          {"merge", file, "-o", output},
          {"forget", file, "P001", "--yes"},
          {"simulate", "hall", "--db", file, "--participants", "1"}};
}

TEST_F(StudyFile, OfANewerSchemaOrNoneIsLeftAsItIs) {
  constexpr std::size_t last_byte_of_user_version = 63;  // by SQLite's "Database File Format"
  std::string newer = sites().north;
  ++newer.at(last_byte_of_user_version);
  for (const std::string& bytes : {newer, std::string(5000, 'x')}) {
    folder_.write("north.sqlite", bytes);
    const auto before = folder_.content();
    for (std::vector<std::string>& command : commands_on(north_, path_of("all.sqlite"))) {
      command.insert(command.begin(), "study");
      expect_one_line(
          sites().hall.run(command), 1,
          bytes == newer ? "north.sqlite: has schema 6" : "north.sqlite: is no database");
    }
    EXPECT_EQ(folder_.content(), before);
  }
}

TEST_F(StudyFile, InAReadOnlyFolderIsOnlyRead) {
  const auto before = folder_.content();
  fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(study_without_privilege({"status", north_}).exit_code, 0);
  EXPECT_EQ(study_without_privilege({"verify", north_}).exit_code, 0);
  expect_one_line(study_without_privilege({"backup", north_}), 1, "north.sqlite.backups: cannot");
  const std::string closed = "the folder " + folder_.path().string() + " cannot be written";
  expect_one_line(study_without_privilege({"merge", north_, "-o", path_of("all.sqlite")}), 1,
                  "all.sqlite: " + closed);
  expect_one_line(study_without_privilege({"forget", north_, "P001", "--yes"}), 1,
                  "north.sqlite: " + closed);
  fs::permissions(folder_.path(), fs::perms::owner_all);
  EXPECT_EQ(folder_.content(), before);
}

// The first is held in the middle of its work.
TEST_F(StudyFile, ASecondControllerLearnsWhoTheFirstIs) {
  const std::vector<std::string> simulate = {"study", "simulate",       "hall", "--db",
                                             north_,  "--participants", "1000"};
  const fs::path lock = north_ + ".controller";
  RunningProgram first(simulate, sites().hall.environment());
  while (!first.has_ended() && (!fs::exists(lock) || fs::file_size(lock) == 0)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  first.kill(SIGSTOP);
  for (const std::vector<std::string>& second :
       {simulate, {"study", "forget", north_, "P001", "--yes"}}) {
    const ProgramResult refused = sites().hall.run(second);
    expect_one_line(refused, 1, "north.sqlite: is being written by foveola ");
    EXPECT_THAT(refused.errors,
                MatchesRegex(fmt::format(".*, process {} of .+ on .+, since 20[0-9-]+T[0-9:.]+Z; "
                                         "let that end.*\n",
                                         first.process())));
  }
}

}  // namespace
}  // namespace foveola::test
