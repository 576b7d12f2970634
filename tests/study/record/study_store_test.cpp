#include "study/record/study_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/digest.h"
#include "small_study.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::MatchesRegex;

class Store : public testing::Test {
 protected:
  std::string stored(const std::string& sql) { return query(path_, sql); }

  std::vector<std::string> column(const std::string& sql) {
    SQLite::Database database(path_, SQLite::OPEN_READONLY);
    SQLite::Statement rows(database, sql);
    std::vector<std::string> values;
    while (rows.executeStep()) {
      values.push_back(rows.getColumn(0).getString());
    }
    return values;
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "study.sqlite";
};

TEST_F(Store, LeavesOneFileInWalMode) {
  {
    StudyStore store(path_, small_protocol());
    RecordedSession(store, facts_of("P01"), small_plan()).begin();
    EXPECT_EQ(folder_.content().count("study.sqlite-wal"), 1U);
  }
  const auto content = folder_.content();
  ASSERT_THAT(content, testing::SizeIs(1));
  // The SQLite file format, section 1.3: 2 at offsets 18 and 19 is WAL.
  EXPECT_EQ(content.at("study.sqlite").substr(18, 2), "\x02\x02");
}

TEST_F(Store, KeepsTheProtocolToTheLetter) {
  { const StudyStore store(path_, small_protocol()); }
  EXPECT_EQ(stored("SELECT protocol_text FROM study"), small_protocol().text);
  EXPECT_EQ(stored("SELECT protocol_sha256 FROM study"), small_protocol().sha256);
  EXPECT_THAT(stored("SELECT created_utc FROM study"),
              MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]{8}\\.[0-9]{3}Z"));
  EXPECT_THAT(column("SELECT name FROM study_scene ORDER BY position"), ElementsAre("box", "hall"));
  EXPECT_THAT(column("SELECT name FROM study_method ORDER BY position"),
              ElementsAre("od", "fv", "mask:file=a.png"));
  EXPECT_THAT(column("SELECT method || ' ' || file_name || ' ' || file_sha256"
                     " FROM study_method_file"),
              ElementsAre("mask:file=a.png a.png " + std::string(64, 'e')));
}

TEST_F(Store, KeepsTheProfilesToTheLetter) {
  { const StudyStore store(path_, small_protocol()); }
  EXPECT_THAT(
      column("SELECT device || ' ' || name || ': ' || toml FROM study_profile"
             " ORDER BY device"),
      ElementsAre("display goggles: kind = \"headset\"\n", "tracker camera: rate_hz = 120\n"));
  EXPECT_EQ(stored("SELECT toml_sha256 FROM study_profile WHERE device = 'tracker'"),
            sha256(std::string_view("rate_hz = 120\n")));
}

TEST_F(Store, WritesEveryRunOfAValidation) {
  StudyStore store(path_, small_protocol());
  RecordedSession session(store, facts_of("P01"), small_plan());
  session.begin_validated();
  EXPECT_THAT(column("SELECT type || ' ' || payload FROM event ORDER BY sequence LIMIT 3"),
              ElementsAre("session_started {\"validations\":2}",
                          "gaze_validated {\"passed\":false}", "gaze_validated {\"passed\":true}"));
  EXPECT_THAT(column("SELECT run || ' of ' || sequence || ': ' || accuracy_deg || ' ' ||"
                     " precision_rms_deg || ' ' || precision_sd_deg || ' ' || data_loss || ' ' ||"
                     " coalesce(correction, 'as it came') || ' ' || passed FROM gaze_run"
                     " ORDER BY run"),
              ElementsAre("1 of 2: 4.0 0.5 0.25 0.75 as it came 0",
                          "2 of 3: 4.0 0.5 0.25 0.75 as it came 0",
                          "3 of 3: 0.5 0.25 0.125 0.0 "
                          R"({"azimuth":[-1.5,1.25,0.0],"elevation":[0.5,0.0,1.0]} 1)"));
  EXPECT_THAT(
      column(
          "SELECT run || '.' || target || ': ' || round(azimuth_deg, 3) || ' ' || elevation_deg ||"
          " ' ' || data_loss || ' ' || samples || ' ' || coalesce("
          "  mean_gaze_azimuth_deg || ' ' || mean_gaze_elevation_deg || ' ' ||"
          "  accuracy_deg || ' ' || precision_rms_deg || ' ' || precision_sd_deg, 'unseen')"
          " FROM gaze_target WHERE run <> 2 ORDER BY run, target"),
      ElementsAre("1.0: 0.0 0.0 0.5 70 0.0 45.0 4.0 0.5 0.25", "1.1: 45.0 0.0 1.0 0 unseen",
                  "3.0: 0.0 0.0 0.0 120 0.0 0.0 0.5 0.25 0.125"));
}

TEST_F(Store, ASessionThatIsRefusedIsOver) {
  StudyStore store(path_, small_protocol());
  RecordedSession session(store, facts_of("P01"), small_plan());
  session.happen(ms(0), SessionStarted{.validations = 1});
  session.happen(ms(1), GazeValidated{.runs = {bad_run()}});
  EXPECT_EQ(stored("SELECT state FROM session"), "refused");
  EXPECT_EQ(stored("SELECT count(*) FROM attempt"), "0");
}

TEST_F(Store, WritesThePlanAndTheFactsBeforeAnythingHappens) {
  StudyStore store(path_, small_protocol());
  store.begin_session(facts_of("P01"), small_plan());
  EXPECT_THAT(column("SELECT scene || ' ' || method || ' ' || scene_position || method_position"
                     " FROM planned_trial ORDER BY trial"),
              ElementsAre("hall fv 00", "hall od 01", "box od 10", "box fv 11"));
  EXPECT_EQ(stored("SELECT seed FROM session"), "18446744073709551615");
  EXPECT_EQ(stored("SELECT kind || ', ' || state || ', ' || program_version || ', ' || compiler ||"
                   " ', ' || build_type || ', ' || processor || ', ' || cores || ', ' ||"
                   " operating_system FROM session"),
            "simulated, created, 0.1.0, GNU 12.2.0, Release, A processor, 2, Linux 6.1");
  EXPECT_EQ(stored("SELECT file_name || ' ' || file_sha256 || ' ' || shown_as FROM session_scene"
                   " WHERE scene = 'hall'"),
            "hall.glb " + std::string(64, 'd') + R"( {"exposure_stops":1.5})");
  EXPECT_EQ(stored("SELECT count(*) FROM event"), "0");
}

TEST_F(Store, GivesEverySessionItsOwnRandomUuid) {
  StudyStore store(path_, small_protocol());
  store.begin_session(facts_of("P01"), small_plan());
  store.begin_session(facts_of("P02"), small_plan());
  const std::vector<std::string> uuids = column("SELECT uuid FROM session");
  ASSERT_THAT(uuids, testing::SizeIs(2));
  EXPECT_NE(uuids[0], uuids[1]);
  // RFC 4122, section 4.4: version 4 in the third group, variant 10 in the fourth.
  const std::string form = "[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}";
  EXPECT_THAT(uuids, testing::Each(MatchesRegex(form)));
}

TEST_F(Store, OneParticipantHasOneSession) {
  StudyStore store(path_, small_protocol());
  EXPECT_FALSE(store.has_participant("P01"));
  store.begin_session(facts_of("P01"), small_plan());
  EXPECT_TRUE(store.has_participant("P01"));
  EXPECT_FALSE(store.has_participant("P02"));
  EXPECT_THAT(refusal([&] { store.begin_session(facts_of("P01"), small_plan()); }),
              HasSubstr("participant P01 already has a session; choose another code"));
  EXPECT_EQ(stored("SELECT count(*) FROM session"), "1");
}

TEST_F(Store, LogsEveryEventWithItsValues) {
  StudyStore store(path_, small_protocol());
  RecordedSession session(store, facts_of("P01"), small_plan());
  session.begin();
  session.run_trial(ms(100), ms(2000), ms(3000), 2);
  EXPECT_THAT(column("SELECT sequence || ' ' || time_ns || ' ' || type FROM event"
                     " ORDER BY session, sequence"),
              ElementsAre("1 0 session_started", "2 10000000 background_answered",
                          "3 99000000 object_chosen", "4 100000000 first_frame_presented",
                          "5 2100000000 outline_marked", "6 3100000000 material_marked",
                          "7 3101000000 artifacts_rated"));
  EXPECT_THAT(
      column("SELECT payload FROM event ORDER BY session, sequence"),
      ElementsAre(R"({"validations":0})",
                  R"({"answers":[{"question":"age","value":31},)"
                  R"({"question":"cg_experience","value":4}]})",
                  R"({"object":"vase"})", R"({"time_ns":100000000})", R"({"time_ns":2100000000})",
                  R"({"time_ns":3100000000})", R"({"rating":2})"));
}

TEST_F(Store, LogsAnObjectWhoseNameIsNoUnicode) {
  StudyStore store(path_, small_protocol());
  RecordedSession session(store, facts_of("P01"), small_plan());
  session.begin();
  session.happen(ms(20), ObjectChosen{"v\xff"});
  EXPECT_EQ(stored("SELECT payload ->> 'object' FROM event WHERE sequence = 3"), "v\xEF\xBF\xBD");
}

TEST_F(Store, FollowsAttemptsToTheirOutcomes) {
  StudyStore store(path_, small_protocol());
  RecordedSession session(store, facts_of("P01"), small_plan());
  session.begin();
  session.happen(ms(20), ObjectChosen{"vase"});
  session.happen(ms(30), FirstFramePresented{ms(30)});
  session.happen(ms(40), OutlineMarked{ms(40)});
  session.happen(ms(50), RetimeRequested{});
  session.happen(ms(60), FirstFramePresented{ms(60)});
  session.happen(ms(70), OutlineMarked{ms(70)});
  session.happen(ms(80), MaterialMarked{ms(80)});
  session.happen(ms(90), ArtifactsRated{1});
  session.happen(ms(100), ObjectChosen{"door"});
  session.happen(ms(110), Interrupted{});
  EXPECT_THAT(column("SELECT trial || ' ' || attempt || ' ' || object || ' ' || outcome || ' ' ||"
                     " coalesce(first_frame_ns, '-') FROM attempt ORDER BY trial, attempt"),
              ElementsAre("0 1 vase retimed 30000000", "0 2 vase rated 60000000",
                          "1 1 door interrupted -"));
  EXPECT_EQ(stored("SELECT state FROM session"), "interrupted");
}

TEST_F(Store, InterruptionBetweenTrialsLeavesAttemptsAlone) {
  StudyStore store(path_, small_protocol());
  RecordedSession session(store, facts_of("P01"), small_plan());
  session.begin();
  session.run_trial(ms(100), ms(2000), ms(3000), 2);
  session.happen(ms(4000), Interrupted{});
  EXPECT_THAT(column("SELECT outcome FROM attempt"), ElementsAre("rated"));
}

TEST_F(Store, KeepsFramesWithTheirHash) {
  StudyStore store(path_, small_protocol());
  RecordedSession session(store, facts_of("P01"), small_plan());
  session.begin();
  session.happen(ms(20), ObjectChosen{"vase"});
  const std::vector<FrameRow> frames(3, FrameRow{.time = Nanoseconds(0x0102), .samples = 7});
  store.record_frames(session.id(), 0, 1, 0, frames);
  store.record_frames(session.id(), 0, 1, 3, {FrameRow{.time = Nanoseconds(0x0304)}});

  EXPECT_THAT(column("SELECT first_frame || '+' || frame_count || ' ' || encoding"
                     " FROM frame_chunk ORDER BY first_frame"),
              ElementsAre("0+3 frames-2", "3+1 frames-2"));
  SQLite::Database database(path_, SQLite::OPEN_READONLY);
  SQLite::Statement rows(database, "SELECT data, data_sha256 FROM frame_chunk");
  ASSERT_TRUE(rows.executeStep());
  const std::string data = rows.getColumn(0).getString();
  ASSERT_EQ(data.size(), 3U * 44U);
  for (std::size_t frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(data.substr(frame * 44, 8), std::string("\x02\x01\0\0\0\0\0\0", 8));
    EXPECT_EQ(data.substr(frame * 44 + 36, 4), std::string("\x07\0\0\0", 4));
  }
  EXPECT_EQ(rows.getColumn(1).getString(), sha256(data));
}

TEST_F(Store, KeepsGazeWithItsHash) {
  StudyStore store(path_, small_protocol());
  RecordedSession session(store, facts_of("P01"), small_plan());
  session.begin();
  session.happen(ms(20), ObjectChosen{"vase"});
  store.record_gaze(session.id(), 0, 1, 0,
                    std::vector<GazeSample>(2, {.time = Nanoseconds(0x0102)}));
  store.record_gaze(session.id(), 0, 1, 2, {{.time = Nanoseconds(0x0304)}});
  EXPECT_THAT(column("SELECT first_sample || '+' || sample_count || ' ' || encoding || ' ' ||"
                     " length(data) FROM gaze_chunk ORDER BY first_sample"),
              ElementsAre("0+2 gaze-1 48", "2+1 gaze-1 24"));
  SQLite::Database database(path_, SQLite::OPEN_READONLY);
  SQLite::Statement rows(database, "SELECT data, data_sha256 FROM gaze_chunk");
  ASSERT_TRUE(rows.executeStep());
  EXPECT_EQ(rows.getColumn(1).getString(), sha256(rows.getColumn(0).getString()));
}

TEST_F(Store, AppendsToAStudyThatExists) {
  {
    StudyStore store(path_, small_protocol());
    RecordedSession(store, facts_of("P01"), small_plan()).begin();
  }
  {
    StudyStore store(path_, small_protocol());
    EXPECT_TRUE(store.has_participant("P01"));
    RecordedSession(store, facts_of("P02"), small_plan()).begin();
  }
  EXPECT_THAT(column("SELECT session || ' ' || sequence FROM event ORDER BY session, sequence"),
              ElementsAre("1 1", "1 2", "2 1", "2 2"));
}

TEST_F(Store, TwoWritersTakeTurns) {
  StudyStore first(path_, small_protocol());
  StudyStore second(path_, small_protocol());
  RecordedSession one(first, facts_of("P01"), small_plan());
  RecordedSession two(second, facts_of("P02"), small_plan());
  one.begin();
  two.begin();
  one.run_trial(ms(100), ms(2000), ms(3000), 2);
  EXPECT_THAT(column("SELECT session || ': ' || max(sequence) FROM event GROUP BY session"),
              ElementsAre("1: 7", "2: 2"));
}

TEST_F(Store, ChangesNothingWhenAnEventCannotBeRecorded) {
  StudyStore store(path_, small_protocol());
  const std::int64_t session = store.begin_session(facts_of("P01"), small_plan());
  const SessionState rating{.phase = Phase::rating};
  const SessionState next{.phase = Phase::choosing_object, .trial = 1};
  refusal([&] { store.record_event(session, ms(1), ArtifactsRated{3}, rating, next); });
  EXPECT_EQ(stored("SELECT count(*) FROM event"), "0");
  EXPECT_EQ(stored("SELECT state FROM session"), "created");
}

}  // namespace
}  // namespace foveola::study
