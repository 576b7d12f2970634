#include "study/record/schema.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "small_study.h"

namespace foveola::study {
namespace {

/// A study in which every table has a row: one trial rated, the next begun.
class Schema : public testing::Test {
 protected:
  Schema() {
    StudyStore store(folder_ / "study.sqlite", small_protocol());
    RecordedSession session(store, facts_of("P01"), small_plan());
    session.begin_validated();
    session.run_trial(ms(100), ms(2000), ms(3000), 2);
    session.happen(ms(4000), ObjectChosen{"door"});
    store.record_frames(session.id(), 0, 1, 0, {FrameRow{}});
    store.record_gaze(session.id(), 0, 1, 0, {GazeSample{}});
    RecordedSession(store, facts_of("P02"), small_plan()).begin();
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
  EXPECT_EQ(bytes.substr(60, 4), std::string("\0\0\0\3", 4));
  EXPECT_EQ(study_application_id, 'F' << 24 | 'o' << 16 | 'v' << 8 | 'l');
  EXPECT_EQ(study_schema_version, 3);
}

TEST_F(Schema, EveryTableIsStrict) {
  EXPECT_EQ(query(folder_ / "study.sqlite",
                  "SELECT group_concat(name) FROM pragma_table_list"
                  " WHERE type = 'table' AND schema = 'main' AND NOT strict"
                  " AND name NOT LIKE 'sqlite%'"),
            "");
  EXPECT_THAT(answer("INSERT INTO event VALUES (1, 99, 'soon', 'now', 'withdrawn', '{}')"),
              testing::HasSubstr("cannot store TEXT value in INTEGER column"));
}

TEST_F(Schema, RecordsAreOnlyAddedTo) {
  const std::vector<std::string> column_of_each_table = {
      "study.protocol_text",     "study_scene.name",     "study_method.name",
      "session_scene.scene",     "planned_trial.method", "event.payload",
      "background_answer.value", "mark.time_ns",         "rating.artifacts",
      "frame_chunk.data",        "gaze_chunk.data",      "gaze_run.passed",
      "gaze_target.samples",     "study_profile.toml",   "study_method_file.file_sha256"};
  for (const std::string& place : column_of_each_table) {
    const std::string table = place.substr(0, place.find('.'));
    const std::string column = place.substr(place.find('.') + 1);
    EXPECT_NE(query(folder_ / "study.sqlite", "SELECT count(*) FROM " + table), "0") << table;
    EXPECT_EQ(answer(fmt::format("UPDATE {0} SET {1} = {1}", table, column)),
              table + " is only added to");
    EXPECT_EQ(answer("DELETE FROM " + table), table + " is only added to");
  }
}

TEST_F(Schema, SessionsAndAttemptsOnlyMoveOn) {
  EXPECT_EQ(answer("UPDATE session SET participant = 'P99'"), "only a session's state changes");
  EXPECT_EQ(answer("DELETE FROM session"), "sessions are never removed");
  EXPECT_EQ(answer("UPDATE attempt SET object = 'x' WHERE trial = 1"),
            "only an attempt's first frame and outcome change");
  EXPECT_EQ(answer("UPDATE attempt SET outcome = 'open' WHERE trial = 0"), "the attempt is over");
  EXPECT_EQ(answer("DELETE FROM attempt"), "attempts are never removed");
  EXPECT_EQ(answer("UPDATE attempt SET first_frame_ns = 5 WHERE trial = 1"), "");
  EXPECT_EQ(answer("UPDATE attempt SET first_frame_ns = 6 WHERE trial = 1"),
            "the attempt has its first frame");
  EXPECT_EQ(answer("UPDATE session SET state = 'withdrawn' WHERE id = 1"), "");
  EXPECT_EQ(answer("UPDATE session SET state = 'completed' WHERE id = 1"), "the session is over");
  EXPECT_EQ(answer("UPDATE session SET state = 'refused' WHERE id = 2"), "");
  EXPECT_EQ(answer("UPDATE session SET state = 'completed' WHERE id = 2"), "the session is over");
}

TEST_F(Schema, RefusesImpossibleValues) {
  const std::string check = "CHECK constraint failed";
  const std::string foreign = "FOREIGN KEY constraint failed";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"INSERT INTO rating VALUES (1, 1, 1, 6)", check},
      {"INSERT INTO rating VALUES (1, 1, 1, 0)", check},
      {"INSERT INTO mark VALUES (1, 1, 1, 'outline', -1, 0)", check},
      {"INSERT INTO mark VALUES (1, 1, 1, 'colour', 1, 0)", check},
      {"INSERT INTO mark VALUES (1, 2, 1, 'outline', 1, 0)", foreign},
      {"INSERT INTO attempt VALUES (1, 4, 1, 'vase', NULL, 'open')", foreign},
      {"INSERT INTO planned_trial VALUES (1, 4, 'box', 'vp', 0, 0)", foreign},
      {"INSERT INTO event VALUES (1, 99, 0, '', 'withdrawn', '[]')", check},
      {"INSERT INTO event VALUES (1, 99, 0, '', 'sneezed', '{}')", check},
      {"INSERT INTO event VALUES (3, 1, 0, '', 'withdrawn', '{}')", foreign},
      {"INSERT INTO frame_chunk SELECT 1, 0, 1, 1, 2, encoding, data, data_sha256"
       " FROM frame_chunk",
       check},
      {"INSERT INTO gaze_chunk SELECT 1, 0, 1, 1, 2, encoding, data, data_sha256 FROM gaze_chunk",
       check},
      {"INSERT INTO gaze_run VALUES (1, 9, 1, 1, 1, 1, 1.5, NULL, 1)", check},
      {"INSERT INTO gaze_run VALUES (1, 9, 1, 1, 1, 1, 0.5, '[]', 1)", check},
      {"INSERT INTO gaze_run VALUES (1, 9, 99, 1, 1, 1, 0.5, NULL, 1)", foreign},
      {"INSERT INTO gaze_target VALUES (1, 9, 0, 0, 0, 1, 0, NULL, NULL, NULL, NULL, NULL)",
       foreign},
      {"INSERT INTO study_profile VALUES ('chair', 'a', 'b', 'c')", check},
      {"INSERT INTO session_scene SELECT 1, 'box', file_name, file_sha256, '[]' FROM session_scene",
       check},
      {"INSERT INTO study_method_file SELECT 'vp', file_name, file_sha256 FROM study_method_file",
       foreign},
      {"INSERT INTO study_method_file VALUES ('fv', 'a.png', 'ABCD')", check},
      {"INSERT INTO study SELECT 2, 'a', 'b', 'c', protocol_sha256, 'd' FROM study", check},
  };
  for (const auto& [sql, message] : cases) {
    EXPECT_THAT(answer(sql), testing::HasSubstr(message)) << sql;
  }
}

}  // namespace
}  // namespace foveola::study
