#include "study/record/write/study_store.h"

#include <optional>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/files/digest.h"
#include "study/record/read/study_records.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

class Store : public StudyFile {
 protected:
  std::string stored(const std::string& sql) { return query(path_, sql); }

  std::vector<std::string> column(const std::string& sql) { return query_column(path_, sql); }
};

TEST_F(Store, LeavesOneWholeFile) {
  {
    StudyStore store(path_, small_protocol());
    begun_session(store);
    EXPECT_EQ(folder_.content().count("study.sqlite-wal"), 1U);
  }
  const auto content = folder_.content();
  ASSERT_THAT(content, SizeIs(1));
  // The SQLite file format, section 1.3: 2 at offsets 18 and 19 is WAL, 1 is not.
  EXPECT_EQ(content.at("study.sqlite").substr(18, 2), "\x01\x01");
}

TEST_F(Store, ACopyWithoutItsLogIsWarnedOf) {
  const fs::path copy = folder_ / "copy.sqlite";
  {
    StudyStore store(path_, small_protocol());
    begun_session(store);
    fs::copy_file(path_, copy);
  }
  EXPECT_THAT(verify_study(copy).warnings,
              ElementsAre(FieldsAre("", HasSubstr("copy.sqlite-wal, which is not beside it"))));
  EXPECT_THAT(verify_study(path_).warnings, IsEmpty());
}

TEST_F(Store, WhoReadsItDoesNotMakeItsEndFail) {
  std::optional<SQLite::Database> reader;
  {
    StudyStore store(path_, small_protocol());
    begun_session(store);
    reader.emplace(path_, SQLite::OPEN_READONLY);
    reader->exec("BEGIN");
    EXPECT_EQ(reader->execAndGet("SELECT count(*) FROM session").getInt(), 1);
  }
  EXPECT_EQ(read_study(path_).sessions.size(), 1U);
  reader.reset();
  EXPECT_THAT(verify_study(path_).faults, IsEmpty());
}

TEST_F(Store, KeepsTheProtocolToTheLetter) {
  {
    const StudyStore store(path_, small_protocol());
  }
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
  EXPECT_THAT(
      column("SELECT device || ' ' || name || ': ' || toml FROM study_profile"
             " ORDER BY device"),
      ElementsAre("display goggles: kind = \"headset\"\n", "tracker camera: rate_hz = 120\n"));
  EXPECT_EQ(stored("SELECT toml_sha256 FROM study_profile WHERE device = 'tracker'"),
            sha256(std::string_view("rate_hz = 120\n")));
  EXPECT_THAT(column("SELECT mark FROM study_mark ORDER BY position"),
              ElementsAre("outline", "material"));
  EXPECT_EQ(
      stored("SELECT rating || ' ' || (question ->> 'kind') || ' ' ||"
             " (question ->> 'minimum') || ' ' || (question ->> 'maximum') FROM study_rating"),
      "artifacts likert 1.0 5.0");
}

TEST_F(Store, WritesEveryRunOfAValidation) {
  StudyStore store(path_, thorough_protocol());
  PlayedSession session(store, facts_of("P01"), thorough_plan(), thorough_protocol());
  session.begin_thoroughly();
  EXPECT_THAT(column("SELECT (payload ->> 'passed') || ' ' || json_array_length(payload, '$.runs')"
                     " FROM event WHERE type = 'gaze_validated' ORDER BY sequence"),
              ElementsAre("0 1", "1 2"));
  EXPECT_THAT(column("SELECT run || ' of ' || sequence || ': ' || accuracy_deg || ' ' ||"
                     " precision_rms_deg || ' ' || precision_sd_deg || ' ' || data_loss || ' ' ||"
                     " coalesce(correction, 'as it came') || ' ' || passed FROM gaze_run"
                     " ORDER BY run"),
              ElementsAre("1 of 3: 4.0 0.5 0.25 0.75 as it came 0",
                          "2 of 4: 4.0 0.5 0.25 0.75 as it came 0",
                          "3 of 4: 0.5 0.25 0.125 0.0 "
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
  StudyStore store(path_, thorough_protocol());
  PlayedSession session(store, facts_of("P01"), thorough_plan(), thorough_protocol());
  session.happen(ms(0), SessionStarted{});
  session.happen(ms(1), ConsentGiven{});
  session.happen(ms(2), GazeValidated{.runs = {bad_run()}});
  session.happen(ms(3), GazeValidated{.runs = {bad_run()}});
  EXPECT_EQ(stored("SELECT state FROM session"), "refused");
  EXPECT_EQ(stored("SELECT count(*) FROM attempt"), "0");
}

TEST_F(Store, WritesThePlanAndTheFactsBeforeAnythingHappens) {
  StudyStore store(path_, small_protocol());
  store.begin_session(facts_of("P01"), small_plan());
  EXPECT_THAT(column("SELECT scene || ' ' || method || ' ' || scene_position || method_position"
                     " FROM planned_trial ORDER BY trial"),
              ElementsAre("hall fv 00", "hall od 01", "box od 10", "box fv 11"));
  EXPECT_THAT(
      column("SELECT kind || coalesce(' ' || questionnaire, '') ||"
             " coalesce(' ' || trial || ' ' || chooses_object, '') FROM planned_step"
             " ORDER BY step"),
      ElementsAre("questionnaire background", "trial 0 1", "trial 1 0", "trial 2 1", "trial 3 0"));
  EXPECT_EQ(stored("SELECT seed FROM session"), "18446744073709551615");
  EXPECT_EQ(stored("SELECT design_row || devices FROM session"), "7{}");
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
  ASSERT_THAT(uuids, SizeIs(2));
  EXPECT_NE(uuids[0], uuids[1]);
  // RFC 4122, section 4.4: version 4 in the third group, variant 10 in the fourth.
  const std::string form = "[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}";
  EXPECT_THAT(uuids, Each(MatchesRegex(form)));
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
  PlayedSession session = begun_session(store);
  session.run_trial(ms(100), ms(2000), ms(3000), 2);
  session.happen(ms(4000), NoteWritten{.text = "coughs"});
  EXPECT_THAT(
      column("SELECT sequence || ' ' || time_ns || ' ' || type FROM event"
             " ORDER BY session, sequence"),
      ElementsAre("1 0 session_started", "2 10000000 questionnaire_answered",
                  "3 99000000 object_chosen", "4 99000000 trial_started",
                  "5 100000000 first_frame_presented", "6 2100000000 marked", "7 3100000000 marked",
                  "8 3101000000 rated", "9 4000000000 note_written"));
  EXPECT_THAT(
      column("SELECT payload FROM event ORDER BY session, sequence"),
      ElementsAre("{}",
                  R"({"questionnaire":"background",)"
                  R"("answers":[{"question":"age","value":31.0},)"
                  R"({"question":"cg_experience","value":4.0}]})",
                  R"({"object":"vase"})", "{}", R"({"time_ns":100000000})",
                  R"({"time_ns":2100000000})", R"({"time_ns":3100000000})",
                  R"({"answers":[{"question":"artifacts","value":2.0}]})", R"({"text":"coughs"})"));
  EXPECT_EQ(stored("SELECT time_ns || text FROM note"), "4000000000coughs");
}

TEST_F(Store, KeepsAnswersOfEveryKindOfForm) {
  StudyStore store(path_, thorough_protocol());
  run_thorough_session(
      store, "P01",
      QuestionnaireAnswered{.questionnaire = "debrief",
                            .answers = {{.question = "sickness", .value = 1.0},
                                        {.question = "comments", .value = "wör\nds"}}});
  EXPECT_THAT(column("SELECT step || ' ' || questionnaire || ' ' || question || ' ' ||"
                     " coalesce(number, text) FROM questionnaire_answer"),
              ElementsAre("3 background age 31.0", "3 background cg_experience 4.0",
                          "10 debrief sickness 1.0", "10 debrief comments wör\nds"));
  EXPECT_EQ(stored("SELECT state FROM session"), "completed");
}

TEST_F(Store, KeepsFalseStartsAmongReactions) {
  StudyStore store(path_, thorough_protocol());
  PlayedSession(store, facts_of("P01"), thorough_plan(), thorough_protocol()).begin_thoroughly();
  EXPECT_THAT(column("SELECT number || ': ' || shown_ns || ' ' || pressed_ns || ' ' || early"
                     " FROM reaction ORDER BY number"),
              ElementsAre("1: 6000000 4000000 1", "2: 6000000 7000000 0", "3: 8000000 9000000 0"));
}

TEST_F(Store, LogsAnObjectWhoseNameIsNoUnicode) {
  StudyStore store(path_, small_protocol());
  PlayedSession session = begun_session(store);
  session.choose_and_start(ms(20), "v\xff");
  EXPECT_EQ(stored("SELECT payload ->> 'object' FROM event WHERE sequence = 3"), "v\xEF\xBF\xBD");
  EXPECT_EQ(stored("SELECT object FROM attempt"), "v\xEF\xBF\xBD");
}

TEST_F(Store, FollowsAttemptsToTheirOutcomes) {
  StudyStore store(path_, thorough_protocol());
  run_thorough_session(store, "P01");
  EXPECT_THAT(column("SELECT trial || ' ' || attempt || ' ' || object || ' ' || outcome || ' ' ||"
                     " coalesce(first_frame_ns / 1000000, '-') FROM attempt"
                     " ORDER BY trial, attempt"),
              ElementsAre("0 1 vase rated 1000", "1 1 vase retimed 2001", "1 2 vase paused 3001",
                          "1 3 vase rated 4000", "2 1 vase interrupted -", "2 2 vase rated 7000",
                          "3 1 vase rated 8000", "4 1 vase rated 9000", "5 1 vase rated 10000"));
  EXPECT_THAT(
      column("SELECT attempt || ' ' || kind || ' ' || (time_ns / 1000000) || ' ' || censored"
             " FROM mark WHERE trial = 1 ORDER BY attempt, time_ns"),
      ElementsAre("1 outline 99 1", "3 outline 300 0", "3 material 400 0"));
  EXPECT_EQ(stored("SELECT question || ' ' || value FROM rating WHERE trial = 1"), "artifacts 4.0");
  EXPECT_EQ(stored("SELECT state FROM session"), "excluded");
}

TEST_F(Store, ASessionWhoseEndIsUndoneContinues) {
  for (const Event& end : {Event(Withdrawn{}), Event(Excluded{.reason = "a slip"})}) {
    const fs::path path = folder_ / name_of(end);
    StudyStore store(path, small_protocol());
    PlayedSession session = begun_session(store);
    session.choose_and_start(ms(20));
    session.happen(ms(30), end);
    session.happen(ms(40), EndUndone{});
    EXPECT_EQ(query(path, "SELECT state FROM session"), "paused");
    session.happen(ms(50), Resumed{});
    session.happen(ms(60), TrialStarted{});
    EXPECT_EQ(query(path, "SELECT group_concat(attempt || outcome) FROM attempt"),
              fmt::format("1{},2open", name_of(end)));
    EXPECT_THAT(verify_study(path).faults, IsEmpty());
  }
}

/// What a program that goes on with a session reads of it.
TEST_F(Store, GivesBackEverySessionWithItsPlanAndEvents) {
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01");
    SessionFacts pilot = facts_of("P02");
    pilot.kind = SessionKind::pilot;
    PlayedSession(store, pilot, small_plan()).begin();
  }
  const StudyStore store(path_, thorough_protocol());
  const std::vector<KnownSession> sessions = store.sessions();
  ASSERT_THAT(sessions, SizeIs(2));
  EXPECT_EQ(sessions[0].participant, "P01");
  EXPECT_EQ(sessions[0].phase, Phase::excluded);
  EXPECT_EQ(sessions[0].seed, 18'446'744'073'709'551'615U);
  EXPECT_EQ(sessions[0].design_row, 7);
  EXPECT_EQ(program_name(sessions[0].build), "Foveola 0.1.0 (GNU 12.2.0, Release)");
  ASSERT_THAT(sessions[0].scenes, SizeIs(2));
  EXPECT_EQ(sessions[0].scenes[1].shown_as, R"({"exposure_stops":1.5})");
  EXPECT_EQ(sessions[1].kind, SessionKind::pilot);

  const Plan plan = store.plan_of(sessions[0].id);
  ASSERT_EQ(plan.size(), thorough_plan().size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    EXPECT_EQ(plan[i].scene, thorough_plan()[i].scene);
    EXPECT_EQ(plan[i].method, thorough_plan()[i].method);
    EXPECT_EQ(plan[i].kind, thorough_plan()[i].kind);
    EXPECT_EQ(plan[i].scene_position, thorough_plan()[i].scene_position);
    EXPECT_EQ(plan[i].method_position, thorough_plan()[i].method_position);
  }

  const std::vector<LoggedEvent> log = store.events_of(sessions[0].id);
  EXPECT_EQ(std::to_string(log.size()), stored("SELECT count(*) FROM event WHERE session = 1"));
  EXPECT_EQ(log.at(11).time, ms(1100));
  EXPECT_EQ(std::get<Marked>(log.at(11).event).time, ms(1100));
  EXPECT_EQ(std::get<Excluded>(log.back().event).reason, "the tracker was lost");
  const auto& validated = std::get<GazeValidated>(log.at(3).event);
  ASSERT_THAT(validated.runs, SizeIs(2));
  EXPECT_EQ(validated.runs[0].quality.targets.at(1).direction, Vec3(1.0F, 0.0F, -1.0F));
  EXPECT_FALSE(validated.runs[0].quality.targets.at(1).seen);
  EXPECT_EQ(validated.runs[1].correction, good_run().correction);
}

TEST_F(Store, KeepsFramesAndGazeCompressedWithTheirHashes) {
  StudyStore store(path_, small_protocol());
  PlayedSession session = begun_session(store);
  session.choose_and_start(ms(20));
  store.record(session.id(),
               FrameChunk{.attempt = {}, .first = 0, .frames = std::vector<FrameRow>(3)});
  store.record(
      session.id(),
      FrameChunk{.attempt = {}, .first = 3, .frames = {FrameRow{.time = Nanoseconds(0x0304)}}});
  store.record(session.id(),
               GazeChunk{.attempt = {}, .first = 0, .samples = std::vector<GazeSample>(2)});
  EXPECT_THAT(column("SELECT first_frame || '+' || frame_count || ' ' || encoding"
                     " FROM frame_chunk ORDER BY first_frame"),
              ElementsAre("0+3 frames-3", "3+1 frames-3"));
  EXPECT_THAT(column("SELECT first_sample || '+' || sample_count || ' ' || encoding"
                     " FROM gaze_chunk"),
              ElementsAre("0+2 gaze-1"));
  EXPECT_EQ(stored("SELECT data_sha256 FROM frame_chunk WHERE first_frame = 0"),
            sha256(stored("SELECT uuid FROM session") + "\n0\n1\n0\n3\nframes-3\n" +
                   std::string(3 * 52, '\0')));
  // RFC 1950: the first byte of a zlib stream with a window of 32 KiB.
  EXPECT_EQ(stored("SELECT hex(substr(data, 1, 1)) FROM frame_chunk WHERE first_frame = 0"), "78");
}

TEST_F(Store, KeepsFilmHashes) {
  StudyStore store(path_, small_protocol());
  PlayedSession session = begun_session(store);
  session.choose_and_start(ms(20));
  store.record(session.id(),
               FilmEntry{.attempt = {}, .hash = {.frame = 12, .sha256 = std::string(64, 'a')}});
  EXPECT_EQ(stored("SELECT trial || attempt || ' ' || frame || film_sha256 FROM film_hash"),
            "01 12" + std::string(64, 'a'));
  EXPECT_EQ(stored("SELECT row_sha256 FROM film_hash"),
            sha256("[\"" + stored("SELECT uuid FROM session") + "\",0,1,12,\"" +
                   std::string(64, 'a') + "\"]"));
}

TEST_F(Store, ChangesNothingWhenAnEventCannotBeRecorded) {
  StudyStore store(path_, small_protocol());
  const std::int64_t session = store.begin_session(facts_of("P01"), small_plan());
  const SessionState rating{.phase = Phase::rating, .step = 1};
  const SessionState next{.phase = Phase::ready, .step = 2};
  refusal([&] {
    store.record(session + 1,
                 EventEntry{.time = ms(1), .event = rated(3), .before = rating, .after = next});
  });
  EXPECT_EQ(stored("SELECT count(*) FROM event"), "0");
  EXPECT_EQ(stored("SELECT state FROM session"), "created");
}

}  // namespace
}  // namespace foveola::study
