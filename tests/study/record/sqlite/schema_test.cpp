#include "study/record/schema.h"

#include <regex>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include "tests/matchers.h"
#include "tests/study/record/small_study.h"

namespace foveola::study {
namespace {

/// A study in which every table has a row: P01's session is over, P02's goes on in its first trial.
class Schema : public testing::Test {
 protected:
  Schema() {
    StudyStore store(folder_ / "study.sqlite", thorough_protocol());
    run_thorough_session(store, "P01");
    PlayedSession second(store, facts_of("P02"), thorough_plan(), thorough_protocol());
    second.begin_thoroughly();
    second.choose_and_start(ms(100));
  }

  /// What SQLite says to the statement; empty if it allows it.
  std::string answer(const std::string& sql) {
    SQLite::Database database(folder_ / "study.sqlite", SQLite::OPEN_READWRITE);
    database.exec("PRAGMA foreign_keys = ON");
    try {
      database.exec(sql);
    } catch (const SQLite::Exception& fault) {
      return fault.what();
    }
    return {};
  }

  TemporaryFolder folder_;
};

TEST_F(Schema, IdentifiesTheFile) {
  const std::string bytes = folder_.content().at("study.sqlite");
  // The SQLite file format, section 1.3: application id at offset 68, user version at 60.
  EXPECT_EQ(bytes.substr(68, 4), "Fovl");
  EXPECT_EQ(bytes.substr(60, 4), std::string("\0\0\0\5", 4));
  EXPECT_EQ(study_application_id, 'F' << 24 | 'o' << 16 | 'v' << 8 | 'l');
  EXPECT_EQ(study_schema_version, 5);
}

TEST_F(Schema, EveryTableIsStrict) {
  EXPECT_EQ(query(folder_ / "study.sqlite",
                  "SELECT group_concat(name) FROM pragma_table_list"
                  " WHERE type = 'table' AND schema = 'main' AND NOT strict"
                  " AND name NOT LIKE 'sqlite%'"),
            "");
  EXPECT_THAT(answer("INSERT INTO event VALUES (1, 99, 'soon', 'now', 'withdrawn', '{}', NULL, "
                     "NULL, NULL, '')"),
              HasSubstr("cannot store TEXT value in INTEGER column"));
}

TEST_F(Schema, RecordsAreOnlyAddedTo) {
  const std::vector<std::string> column_of_each_table = {"study.protocol_text",
                                                         "study_scene.name",
                                                         "study_method.name",
                                                         "study_profile.toml",
                                                         "study_mark.mark",
                                                         "study_rating.question",
                                                         "session_scene.scene",
                                                         "planned_trial.method",
                                                         "planned_step.kind",
                                                         "event.payload",
                                                         "event.hash",
                                                         "frame_chunk.data",
                                                         "gaze_chunk.data",
                                                         "film_hash.film_sha256",
                                                         "study_method_file.file_sha256"};
  for (const std::string& place : column_of_each_table) {
    const std::string table = place.substr(0, place.find('.'));
    const std::string column = place.substr(place.find('.') + 1);
    EXPECT_NE(query(folder_ / "study.sqlite", "SELECT count(*) FROM " + table), "0") << table;
    EXPECT_EQ(answer(fmt::format("UPDATE {0} SET {1} = {1}", table, column)),
              table + " is only added to");
    EXPECT_EQ(answer("DELETE FROM " + table), table + " is only added to");
  }
}

TEST_F(Schema, EveryTableIsGuarded) {
  EXPECT_EQ(query(folder_ / "study.sqlite",
                  "SELECT coalesce(group_concat(name), '') FROM sqlite_schema AS t"
                  " WHERE type = 'table' AND NOT EXISTS (SELECT 1 FROM sqlite_schema"
                  "  WHERE type = 'trigger' AND tbl_name = t.name AND sql LIKE '%BEFORE DELETE%')"),
            "");
}

TEST_F(Schema, WhatFollowsFromTheLogCannotBeWritten) {
  for (const char* view : {"attempt", "gaze_run", "gaze_target", "mark", "questionnaire_answer",
                           "rating", "reaction"}) {
    EXPECT_NE(query(folder_ / "study.sqlite", fmt::format("SELECT count(*) FROM {}", view)), "0");
    EXPECT_THAT(answer(fmt::format("UPDATE {} SET session = session", view)),
                HasSubstr(fmt::format("cannot modify {} because it is a view", view)));
  }
}

TEST_F(Schema, SessionsOnlyMoveOn) {
  EXPECT_EQ(answer("UPDATE session SET participant = 'P99' WHERE id = 2"),
            "only a session's state changes");
  EXPECT_EQ(answer("UPDATE session SET devices = '{}' WHERE id = 2"),
            "only a session's state changes");
  EXPECT_EQ(answer("DELETE FROM session"), "sessions are never removed");
}

TEST_F(Schema, SessionsThatAreOverStayOver) {
  EXPECT_EQ(answer("UPDATE session SET state = 'completed' WHERE id = 1"), "the session is over");
  for (const char* state : {"paused", "interrupted", "marking"}) {
    EXPECT_EQ(answer(fmt::format("UPDATE session SET state = '{}' WHERE id = 2", state)), "");
  }
  for (const char* state : {"completed", "withdrawn", "excluded", "refused"}) {
    StudyStore(folder_ / state, small_protocol()).begin_session(facts_of("P03"), small_plan());
    SQLite::Database database(folder_ / state, SQLite::OPEN_READWRITE);
    database.exec(fmt::format("UPDATE session SET state = '{}'", state));
    EXPECT_THROW(database.exec("UPDATE session SET state = 'marking'"), SQLite::Exception) << state;
    const bool can_be_undone =
        std::string(state) == "withdrawn" || std::string(state) == "excluded";
    EXPECT_EQ(database.tryExec("UPDATE session SET state = 'paused'") == SQLITE_OK, can_be_undone)
        << state;
  }
}

TEST_F(Schema, AMethodStandsOnceWithASceneInTestTrialsOnly) {
  EXPECT_THAT(answer("INSERT INTO planned_trial VALUES (1, 9, 'test', 'box', 'od', 0, 0)"),
              HasSubstr("UNIQUE constraint failed"));
  EXPECT_EQ(answer("INSERT INTO planned_trial VALUES (1, 9, 'practice', 'box', 'od', 0, 0)"), "");
  EXPECT_EQ(answer("INSERT INTO planned_trial VALUES (1, 10, 'catch', 'box', 'od', 0, 0)"), "");
}

TEST_F(Schema, RefusesImpossibleValues) {
  const std::string check = "CHECK constraint failed";
  const std::string foreign = "FOREIGN KEY constraint failed";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"INSERT INTO planned_trial VALUES (1, 9, 'test', 'box', 'vp', 0, 0)", foreign},
      {"INSERT INTO planned_trial VALUES (1, 9, 'exam', 'box', 'fv', 0, 0)", check},
      {"INSERT INTO planned_step VALUES (1, 20, 'consent', 'background', NULL, NULL, NULL)", check},
      {"INSERT INTO planned_step VALUES (1, 20, 'reaction', NULL, NULL, NULL, NULL)", check},
      {"INSERT INTO planned_step VALUES (1, 20, 'trial', NULL, NULL, 99, 1)", foreign},
      {"INSERT INTO event VALUES (1, 99, 0, '', 'withdrawn', '[]', NULL, NULL, NULL, event_hash)",
       check},
      {"INSERT INTO event VALUES (1, 99, 0, '', 'sneezed', '{}', NULL, NULL, NULL, event_hash)",
       check},
      {"INSERT INTO event VALUES (1, 99, 0, '', 'withdrawn', '{}', NULL, NULL, NULL, 'ABC')",
       check},
      {"INSERT INTO event VALUES (1, 99, 0, '', 'withdrawn', '{}', 1, NULL, NULL, event_hash)",
       check},
      {"INSERT INTO event VALUES (1, 99, 0, '', 'withdrawn', '{}', 1, 1, '[]', event_hash)", check},
      {"INSERT INTO forgotten VALUES ('abc', 1, event_hash, '')", check},
      {"INSERT INTO forgotten VALUES (event_hash, -1, event_hash, '')", check},
      {"INSERT INTO event VALUES (3, 1, 0, '', 'withdrawn', '{}', NULL, NULL, NULL, event_hash)",
       foreign},
      {"UPDATE session SET state = 'asleep' WHERE id = 2", check},
      {"INSERT INTO frame_chunk SELECT 1, 0, 1, 1, 0, encoding, data, data_sha256"
       " FROM frame_chunk",
       check},
      {"INSERT INTO gaze_chunk SELECT 1, 0, 1, 1, 1, 'gaze-9', data, data_sha256 FROM gaze_chunk",
       check},
      {"INSERT INTO film_hash VALUES (1, 0, 1, 1, 'abc', 'abc')", check},
      {"INSERT INTO film_hash SELECT 2, 9, 1, 1, film_sha256, row_sha256 FROM film_hash LIMIT 1",
       foreign},
      {"INSERT INTO study_profile VALUES ('chair', 'a', 'b', 'c')", check},
      {"INSERT INTO session_scene SELECT 1, 'box', file_name, file_sha256, '[]' FROM session_scene",
       check},
      {"INSERT INTO study_method_file SELECT 'vp', file_name, file_sha256 FROM study_method_file",
       foreign},
      {"INSERT INTO study_method_file VALUES ('fv', 'a.png', 'ABCD')", check},
      {"INSERT INTO study SELECT 2, 'a', 'b', 'c', protocol_sha256, 'd' FROM study", check},
  };
  const std::string a_hash = "'" + std::string(64, 'a') + "'";
  for (const auto& [pattern, message] : cases) {
    const std::string sql = std::regex_replace(pattern, std::regex("event_hash"), a_hash);
    EXPECT_THAT(answer(sql), HasSubstr(message)) << sql;
  }
}

}  // namespace
}  // namespace foveola::study
