#include "study/record/migration.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "study/record/database.h"
#include "study/record/recorded_frames.h"
#include "study/record/recorded_gaze.h"
#include "study/record/study_records.h"
#include "study/record/table_rows.h"
#include "study_file.h"

namespace foveola::study {
namespace {

/// A study of schema 3, made by that schema's own SQL.
class Migration : public StudyFile {
 protected:
  Migration() {
    SQLite::Database database(path_, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec("PRAGMA foreign_keys = ON");
    for (const char* name : {"schema-3.sql", "schema-3-study.sql"}) {
      database.exec(read_file(fs::path(TEST_DATA_DIR) / "records" / name));
    }
    database.exec("PRAGMA journal_mode = WAL");
  }

  /// Opens the study to write, which migrates it.
  void migrate() { const StudyStore store(path_, small_protocol()); }
};

/// Whatever was recorded in a file of schema 3.
std::vector<std::string> rows_of_schema_3(const fs::path& path) {
  SQLite::Database database(path, SQLite::OPEN_READONLY);
  std::vector<std::string> digests;
  for (const char* table : {"study", "study_profile", "session", "session_scene", "planned_trial",
                            "event", "gaze_run", "gaze_target", "background_answer", "attempt",
                            "mark", "rating", "frame_chunk", "gaze_chunk"}) {
    digests.push_back(digest_of_rows(database, table));
  }
  return digests;
}

void expect_records_of_schema_3(const StudyRecords& records) {
  EXPECT_THAT(records.sessions,
              ElementsAre(FieldsAre("P01", "human", "completed", std::nullopt, ""),
                          FieldsAre("P02", "simulated", "interrupted", std::nullopt, ""),
                          FieldsAre("P03", "simulated", "marking", std::nullopt, ""),
                          FieldsAre("P04", "pilot", "withdrawn", std::nullopt, ""),
                          FieldsAre("P05", "simulated", "created", std::nullopt, "")));
  ASSERT_THAT(records.trials, testing::SizeIs(16));
  EXPECT_THAT(records.trials[0],
              FieldsAre("P01", "hall", "fv", 0, 0, 2, 0.25, 0.5, false, false, 2));
  EXPECT_THAT(records.trials[1],
              FieldsAre("P01", "hall", "od", 0, 1, 1, 0.999, 120.0, false, true, 5));
  EXPECT_THAT(records.trials[3], FieldsAre("P01", "box", "fv", 1, 1, 1, 0.1, 0.2, false, false, 1));
  EXPECT_EQ(records.trials[4].attempts, 1);
  EXPECT_EQ(records.trials[12].attempts, 0);
  EXPECT_THAT(records.background,
              ElementsAre(FieldsAre("P01", "age", 31.0), FieldsAre("P01", "cg_experience", 4.0)));
}

TEST_F(Migration, ReadersNeedNone) {
  const auto before = folder_.content();
  expect_records_of_schema_3(read_study(path_));
  EXPECT_THAT(read_gaze(path_, "P01", 0), testing::SizeIs(4));
  EXPECT_THAT(verify_study(path_).faults, IsEmpty());
  EXPECT_EQ(folder_.content(), before);
}

TEST_F(Migration, BringsTheFileToThisSchemaAndKeepsACopy) {
  const std::vector<std::string> before = rows_of_schema_3(path_);
  migrate();
  EXPECT_THAT(folder_.entries(), ElementsAre("study.sqlite", "study.sqlite.schema-3.sqlite"));
  EXPECT_EQ(rows_of_schema_3(copy_of_schema(path_, 3)), before);
  EXPECT_EQ(query(copy_of_schema(path_, 3), "PRAGMA user_version"), "3");
  EXPECT_EQ(query(path_, "PRAGMA user_version"), "4");
  EXPECT_EQ(query(path_, "PRAGMA integrity_check"), "ok");
  expect_records_of_schema_3(read_study(path_));
}

TEST_F(Migration, LosesNothingThatWasMeasured) {
  migrate();
  EXPECT_THAT(query_column(path_,
                           "SELECT trial || ' ' || attempt || ' ' || object || ' ' ||"
                           " coalesce(first_frame_ns / 1000000, '-') || ' ' || outcome"
                           " FROM attempt WHERE session = 1 ORDER BY trial, attempt"),
              ElementsAre("0 1 vase 1000 retimed", "0 2 vase 2000 rated", "1 1 vase 3001 rated",
                          "2 1 vase 126000 rated", "3 1 vase 127000 rated"));
  EXPECT_THAT(query_column(path_, "SELECT outcome FROM attempt WHERE session > 1 ORDER BY session"),
              ElementsAre("interrupted", "open", "withdrawn"));
  EXPECT_THAT(query_column(path_,
                           "SELECT run || ' ' || accuracy_deg || ' ' || data_loss || ' ' ||"
                           " coalesce(correction, '-') FROM gaze_run ORDER BY run"),
              ElementsAre("1 4.0 0.75 -",
                          R"(2 0.5 0.0 {"azimuth":[-1.5,1.25,0.0],"elevation":[0.5,0.0,1.0]})"));
  EXPECT_THAT(query_column(path_,
                           "SELECT round(azimuth_deg, 4) || ' ' || samples || ' ' ||"
                           " coalesce(round(mean_gaze_elevation_deg, 4), '-')"
                           " FROM gaze_target ORDER BY run, target"),
              ElementsAre("0.0 70 45.0", "45.0 0 -", "0.0 120 0.0"));
  SQLite::Database database(path_, SQLite::OPEN_READONLY);
  const std::vector<FrameRow> frames = frames_of(database, 1, 0, 2);
  ASSERT_THAT(frames, testing::SizeIs(3));
  EXPECT_EQ(frames[2].time, ms(2));
  EXPECT_EQ(frames[2].samples, 1002U);
  EXPECT_THAT(read_gaze(path_, "P01", 0), testing::SizeIs(4));
}

TEST_F(Migration, SaysWhereSessionsComeFromAndChainsTheirEvents) {
  migrate();
  EXPECT_EQ(query(path_, "SELECT group_concat(DISTINCT migrated_from) FROM session"), "3");
  EXPECT_EQ(query(path_, "SELECT uuid || started_utc FROM session WHERE id = 1"),
            "11111111-1111-4111-8111-1111111111112026-11-01T09:00:00.000Z");
  EXPECT_THAT(verify_study(path_).faults, IsEmpty());
  tamper(path_, "UPDATE event SET time_ns = 7 WHERE session = 1 AND sequence = 3");
  EXPECT_THAT(verify_study(path_).faults,
              ElementsAre(FieldsAre("P01", "event 3 is not what was written")));
}

TEST_F(Migration, WhatWasLeftCanBeGoneOnWith) {
  migrate();
  StudyStore store(path_, small_protocol());
  EXPECT_EQ(store.sessions().at(1).phase, Phase::interrupted);
  PlayedSession session(store, facts_of("P06"), small_plan());
  session.begin();
  EXPECT_THAT(read_study(path_).sessions, testing::SizeIs(6));
}

TEST_F(Migration, ARefusalChangesNothing) {
  const auto before = folder_.content();
  EXPECT_THAT(refusal([&] { const StudyStore store(path_, other_protocol()); }),
              HasSubstr("was begun with another protocol"));
  EXPECT_EQ(folder_.content(), before);
}

TEST_F(Migration, EventsThatCannotHaveHappenedAreRefused) {
  tamper(path_, "UPDATE event SET type = 'material_marked' WHERE session = 1 AND sequence = 6");
  const auto before = folder_.content();
  EXPECT_THAT(refusal([&] { read_study(path_); }),
              testing::AllOf(testing::StartsWith(path_.string()), HasSubstr("session 1"),
                             HasSubstr("in the state armed, which cannot be")));
  EXPECT_THAT(refusal([&] { migrate(); }), HasSubstr("which cannot be"));
  EXPECT_EQ(folder_.content(), before);
}

}  // namespace
}  // namespace foveola::study
