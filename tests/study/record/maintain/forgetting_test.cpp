#include <SQLiteCpp/SQLiteCpp.h>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "study/record/read/study_records.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

constexpr const char* code = "PERSON-0123";

/// PERSON-0123 between two others, with a backup from before and one from after.
class Forgetting : public StudyFile {
 protected:
  Forgetting() {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01");
    store.back_up(new_backup(path_));
    run_thorough_session(store, code);
    run_thorough_session(store, "P03");
    store.back_up(new_backup(path_));
    uuid_ =
        query(path_, std::string("SELECT uuid FROM session WHERE participant = '") + code + "'");
  }

  /// All bytes of all files of the study.
  std::string everything() const {
    std::string bytes;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      bytes += entry.is_regular_file() ? read_file(entry.path()) : "";
    }
    return bytes;
  }

  std::vector<fs::path> backups() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(backup_folder(path_))) {
      if (entry.path().extension() == ".sqlite") {
        files.push_back(entry.path());
      }
    }
    std::sort(files.begin(), files.end());
    return files;
  }

  std::string uuid_;
};

TEST_F(Forgetting, ListsOtherNamesByWhichThePersonStays) {
  fs::create_hard_link(backups().back(), folder_ / "kept.sqlite");
  EXPECT_THAT(forget_participant(path_, code).remaining,
              ElementsAre(FieldsAre(folder_ / "kept.sqlite", "holds the session's UUID"),
                          FieldsAre(backups().back(), HasSubstr("has 2 names"))));
}

TEST_F(Forgetting, ListsAllThatOtherCommandsWrote) {
  const std::string text = read_file(path_);
  fs::create_directories(backup_folder(path_) / "older");
  folder_.write("study.sqlite.backups/older/a.sqlite", text);
  folder_.write("report/bids/sub-PERSON-0123_gaze.tsv", "1");
  folder_.write("receipt.csv", "trial,code\n1,PERSON-0123\n");
  folder_.write("code-of-another.csv", "PERSON-01234\n");
  folder_.write("head.txt", "session   " + uuid_ + " 31 " + std::string(64, 'a'));
  {
    StudyStore other(folder_ / "other.sqlite", other_protocol());
    PlayedSession(other, facts_of(code), small_plan()).begin();
  }
  folder_.write("study.sqlite.backups/.old.sqlite.1.partial", text);
  folder_.write("quoted.txt", "session " + uuid_ + " of a person");
  fs::create_symlink("/dev/zero", folder_ / "link");
  folder_.write("locked/a.csv", "1");
  fs::permissions(folder_ / "locked", fs::perms::none);
  const Forgotten forgotten = forget_participant(path_, code);
  fs::permissions(folder_ / "locked", fs::perms::owner_all);
  EXPECT_EQ(forgotten.files, 3U) << "a backup in a folder of its own is one";
  std::vector<std::string> remaining;
  for (const RemainingCopy& copy : forgotten.remaining) {
    remaining.push_back(copy.file.lexically_relative(folder_.path()).string() + " " + copy.what);
  }
  std::erase(remaining, "locked cannot be read");  // but by root
  EXPECT_THAT(remaining, ElementsAre("quoted.txt holds the session's UUID",
                                     "receipt.csv holds the code PERSON-0123",
                                     "report/bids/sub-PERSON-0123_gaze.tsv is named after"
                                     " PERSON-0123"));
  EXPECT_FALSE(fs::exists(backup_folder(path_) / ".old.sqlite.1.partial"));
}

TEST_F(Forgetting, ListsWhatOthersTypedOfThePerson) {
  {
    StudyStore store(path_, thorough_protocol());
    store.record(3,
                 EventEntry{.time = ms(90'000), .event = NoteWritten{"late:\nPERSON-0123 left"}});
    store.record(3, EventEntry{.time = ms(91'000), .event = NoteWritten{"not PERSON-01234"}});
  }
  EXPECT_THAT(forget_participant(path_, code).mentions,
              ElementsAre(MatchesRegex("event [0-9]+ of P03")));
}

TEST_F(Forgetting, ContinuesBehindABackupThatCannotBeRead) {
  const fs::path damaged = backups().front();
  write_file(damaged, "SQLite format 3");
  const Forgotten forgotten = forget_participant(path_, code);
  EXPECT_EQ(forgotten.files, 2U);
  EXPECT_THAT(forgotten.remaining, ElementsAre(FieldsAre(damaged, HasSubstr("is no database"))));
  fs::remove(damaged);
  EXPECT_THAT(refusal([&] { forget_participant(path_, code); }), HasSubstr("has no participant"));
}

TEST_F(Forgetting, LeavesATombstoneWithoutPersonalData) {
  const std::string tombstone =
      query(path_,
            "SELECT count(*) || ' ' || (SELECT hash FROM event WHERE session = 2 ORDER BY sequence"
            " DESC) FROM event WHERE session = 2");
  forget_participant(path_, code);
  EXPECT_EQ(query(path_, "SELECT uuid_sha256 || ' ' || events || ' ' || last_hash FROM forgotten"),
            sha256(uuid_) + " " + tombstone);
}

TEST_F(Forgetting, LeavesNoByteOfThePerson) {
  EXPECT_THAT(everything(), AllOf(HasSubstr(code), HasSubstr(uuid_)));
  const Forgotten forgotten = forget_participant(path_, code);
  EXPECT_EQ(forgotten.files, 2U) << "the study and the newer backup";
  EXPECT_THAT(everything(), Not(AnyOf(HasSubstr(code), HasSubstr(uuid_))));
}

TEST_F(Forgetting, KeepsEverybodyElse) {
  const std::string others =
      "SELECT group_concat(participant || uuid || hash) FROM event JOIN session"
      " ON session.id = session WHERE participant <> 'PERSON-0123' AND type = 'excluded'";
  const std::string before = query(path_, others);
  forget_participant(path_, code);
  EXPECT_EQ(query(path_, others), before);
  EXPECT_THAT(query_column(path_, "SELECT participant FROM session ORDER BY id"),
              ElementsAre("P01", "P03"));
  EXPECT_THAT(verify_study(path_).faults, IsEmpty());
  EXPECT_THAT(query_column(backups().at(0), "SELECT participant FROM session"), ElementsAre("P01"));
  EXPECT_THAT(query_column(backups().at(1), "SELECT participant FROM session ORDER BY id"),
              ElementsAre("P01", "P03"));
  EXPECT_THAT(verify_study(backups().at(1)).faults, IsEmpty());
  StudyStore store(path_, thorough_protocol());
  EXPECT_FALSE(store.has_participant(code));
  run_thorough_session(store, "P04");
}

TEST_F(Forgetting, ReachesWhatACrashLeft) {
  const TemporaryFolder crashed;
  const fs::path path = crashed / "study.sqlite";
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "PERSON-0999");
    fs::copy(path_, path);
    fs::copy(path_.string() + "-wal", path.string() + "-wal");
  }
  crashed.write(".study.sqlite.1.partial", "half of PERSON-0999");
  forget_participant(path, "PERSON-0999");
  EXPECT_THAT(crashed.entries(), ElementsAre("study.sqlite"));
  EXPECT_THAT(crashed.content().at("study.sqlite"), Not(HasSubstr("PERSON-0999")));
  EXPECT_THAT(verify_study(path).faults, IsEmpty());
}

TEST_F(Forgetting, CanBeDoneAgainAfterAKill) {
  const fs::path newer = backups().at(1);
  const std::string with_the_person = read_file(newer);
  forget_participant(path_, code);
  write_file(newer, with_the_person);  // as if it had not been reached
  EXPECT_EQ(forget_participant(path_, code).files, 1U);
  EXPECT_THAT(everything(), Not(HasSubstr(uuid_)));
}

TEST_F(Forgetting, RefusesWhoeverIsNotThere) {
  const std::string before = everything();
  EXPECT_THAT(refusal([&] { forget_participant(path_, "P99"); }),
              AllOf(HasSubstr("has no participant P99"), HasSubstr("foveola study status")));
  EXPECT_EQ(everything(), before);
}

TEST_F(Forgetting, WaitsForNoController) {
  const StudyStore controller(path_, thorough_protocol());
  EXPECT_THAT(refusal([&] { forget_participant(path_, code); }), HasSubstr("is being written by"));
}

}  // namespace
}  // namespace foveola::study
