#include "study/simulation/virtual_session.h"

#include <map>

#include "study/record/read/recorded_gaze.h"
#include "study/record/read/recorded_session.h"
#include "study/record/write/recorders.h"
#include "study/simulation/rendered_attempt.h"
#include "tests/matchers.h"
#include "tests/study/participant/fake_participant.h"
#include "tests/study/record/small_study.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// A wall in front of the viewer, by an environment that lights it.
SceneSource wall(const TemporaryFolder& folder) {
  SceneSource source;
  source.name = "box";
  source.file =
      folder.write("wall.obj", "v -5 -5 -2\nv 5 -5 -2\nv 5 5 -2\nv -5 5 -2\nf 1 2 3\nf 1 3 4\n");
  source.camera_position = Vec3(0.0F);
  source.environment_radiance = Rgb(1.0F);
  source.objects = {{.name = "corner", .position = {-1.0F, 0.0F, -2.0F}},
                    {.name = "middle", .position = {0.0F, 0.0F, -2.0F}}};
  return source;
}

Protocol wall_protocol() {
  Protocol protocol = small_protocol();
  protocol.scenes = {{.name = "box"}};
  protocol.methods = {"od", "fv"};
  protocol.method_files.clear();
  protocol.machine = {.samples_per_second = 20'000.0, .frame_rate_hz = 50.0};
  protocol.film = {.width = 32, .height = 16, .max_depth = 1};
  protocol.display.view_width = 8;
  protocol.display.view_height = 8;
  protocol.timing = {.mark_timeout_s = 2.0, .rating_s = 0.4};
  protocol.catch_trials = {.count = 1, .timeout_s = 0.5};
  protocol.reaction = ReactionSettings{.presses = 2};
  protocol.marks = {{.id = "outline", .simulated = "outline"},
                    {.id = "material", .simulated = "material"},
                    {.id = "shadow", .simulated = "material"}};
  protocol.ratings = {{.id = "artifacts"}};
  protocol.questionnaires = {{.id = "background", .questions = {}}};
  protocol.phases = {{.kind = PhaseEntry::Kind::questionnaire, .questionnaire = "background"},
                     {.kind = PhaseEntry::Kind::reaction},
                     {.kind = PhaseEntry::Kind::trials}};
  return protocol;
}

Plan wall_plan() {
  return {{.scene = "box", .method = "od"},
          {.scene = "box", .method = "od", .kind = TrialKind::catch_trial},
          {.scene = "box", .method = "fv", .method_position = 1}};
}

class VirtualSessionTest : public testing::Test {
 protected:
  VirtualSessionTest() {
    stages_["box"] = std::make_unique<SceneStage>(wall(folder_), workers_);
    SessionFacts facts = facts_of("P001");
    facts.scenes.clear();
    session_ = store_.begin_session(facts, plan_);
  }

  SessionOutcome run(FakeParticipant& participant) {
    participant.sees_in_blackness = false;
    StoreRecorder recorder(store_, session_);
    VirtualSession session({.protocol = protocol_,
                            .stages = stages_,
                            .recorder = recorder,
                            .make_attempt =
                                [&](const TrialAttemptSetting& setting) {
                                  return std::make_unique<RenderedAttempt>(setting, workers_);
                                },
                            .seed = {.seed = 5, .design_row = 0},
                            .on_trial = [this](std::size_t trial) { begin_trial(trial); },
                            .stop = stop_.get_token()},
                           plan_, participant,
                           position_after(procedure_of(protocol_, plan_),
                                          store_.events_of(session_), "participant P001"));
    return session.run();
  }

  void begin_trial(std::size_t trial) {
    if (trial == stop_in_trial_) {
      stop_.request_stop();
    }
  }

  std::string value(const std::string& sql) { return query(path_, sql); }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "study.sqlite";
  Protocol protocol_ = wall_protocol();
  Plan plan_ = wall_plan();
  Workers workers_{1};
  SceneStages stages_;
  StudyStore store_{path_, protocol_};
  std::int64_t session_ = 0;
  std::stop_source stop_;
  std::optional<std::size_t> stop_in_trial_;
};

TEST_F(VirtualSessionTest, GoesThroughEveryStep) {
  FakeParticipant participant;
  const SessionOutcome outcome = run(participant);
  EXPECT_EQ(outcome.phase, Phase::completed);
  EXPECT_EQ(outcome.trials, 3U);
  EXPECT_THAT(participant.forms, ElementsAre("background"));
  EXPECT_THAT(participant.objects, ElementsAre("middle", "middle", "middle"));
  EXPECT_THAT(participant.turns, Each(Nanoseconds(0)));
  using enum Task;
  EXPECT_THAT(participant.tasks,
              ElementsAre(mark_outline, mark_material, mark_material, look_around,  //
                          mark_outline, mark_material, mark_material, look_around,  //
                          mark_outline, mark_material, mark_material, look_around));
  EXPECT_EQ(value("SELECT group_concat(pressed_ns - shown_ns) FROM reaction"),
            "300000000,300000000");
}

// The first glance is at the first frame, and the next one 0.1 seconds later: the marks come 150 ms
// after the first glance for each.
TEST_F(VirtualSessionTest, MarksAreTimedFromTheFirstFrame) {
  FakeParticipant participant;
  run(participant);
  EXPECT_EQ(value("SELECT group_concat(time_ns / 1000000) FROM (SELECT time_ns FROM mark"
                  " WHERE trial = 0 ORDER BY time_ns)"),
            "150,350,550");
  EXPECT_EQ(value("SELECT group_concat(kind) FROM (SELECT kind FROM mark WHERE trial = 0"
                  " ORDER BY time_ns)"),
            "outline,material,shadow");
  EXPECT_EQ(value("SELECT sum(censored) FROM mark WHERE trial <> 1"), "0");
}

TEST_F(VirtualSessionTest, NothingIsTracedInACatchTrial) {
  FakeParticipant participant;
  run(participant);
  EXPECT_EQ(value("SELECT group_concat(time_ns || ' ' || censored) FROM mark WHERE trial = 1"),
            "500000000 1,500000000 1,500000000 1");
  EXPECT_EQ(value("SELECT count(*) FROM film_hash WHERE trial = 1"), "1");
  EXPECT_EQ(value("SELECT count(DISTINCT film_sha256) FROM film_hash"), "3");
}

// Frames use the filtered gaze; the record has both, and the one follows from the other.
TEST_F(VirtualSessionTest, RecordsTheGazeAsItCameAndAsItWasFiltered) {
  constexpr std::size_t trial = 2;
  protocol_.tracker.simulated.precision_deg = 0.0;
  protocol_.tracker.filter.extrapolate_s = 0.05;
  FakeParticipant participant;
  participant.gaze_deg_per_s = 20.0;
  run(participant);
  std::map<Nanoseconds, Vec3> seen;
  for (const GazeSample& sample : read_gaze(path_, "P001", trial)) {
    seen[sample.time] = sample.direction;
  }
  EXPECT_GT(seen.size(), 50U);
  const RecordedSession session = read_session(path_, "P001");
  const RecordedFrames recorded = read_frames(path_, session.known, {.trial = trial});
  const auto azimuth_deg = [](const Vec3& direction) {
    return degrees(azimuth_elevation(direction).azimuth_rad);
  };
  ASSERT_GT(recorded.frames.size(), 30U);
  for (std::size_t i = 10; i < recorded.frames.size(); ++i) {
    const FrameRow& frame = recorded.frames[i];
    EXPECT_TRUE(frame.gaze_valid);
    EXPECT_GE(frame.gaze_age, nanoseconds_from_seconds(protocol_.tracker.simulated.latency_s));
    const auto used = seen.find(frame.time - frame.gaze_age);
    ASSERT_NE(used, seen.end()) << "its age is that of the sample that it comes from";
    EXPECT_NEAR(azimuth_deg(frame.gaze) - azimuth_deg(used->second), 20.0 * 0.05, 1e-3) << i;
  }
}

TEST_F(VirtualSessionTest, ATimingThatFailedIsDoneAgain) {
  FakeParticipant participant;
  participant.retimed_turn = 1;
  EXPECT_EQ(run(participant).phase, Phase::completed);
  EXPECT_EQ(value("SELECT group_concat(trial || ' ' || attempt || ' ' || outcome, ', ') FROM"
                  " (SELECT * FROM attempt ORDER BY trial, attempt)"),
            "0 1 retimed, 0 2 rated, 1 1 rated, 2 1 rated");
  EXPECT_THAT(participant.trials_before, ElementsAre(0, 0, 1, 2));
  EXPECT_NE(participant.attempts[0], participant.attempts[1]) << "is left to chance anew";
}

TEST_F(VirtualSessionTest, WhoWantsToWithdrawsBetweenTrials) {
  FakeParticipant participant;
  participant.withdraws_before = 2;
  const SessionOutcome outcome = run(participant);
  EXPECT_EQ(outcome.phase, Phase::withdrawn);
  EXPECT_EQ(outcome.trials, 2U);
  EXPECT_EQ(value("SELECT state FROM session"), "withdrawn");
}

TEST_F(VirtualSessionTest, AStoppedSessionGoesOnAsIfNothingHadBeen) {
  FakeParticipant first;
  stop_in_trial_ = 2;
  EXPECT_EQ(run(first).phase, Phase::interrupted);
  stop_ = std::stop_source();
  stop_in_trial_.reset();
  FakeParticipant second;
  const SessionOutcome outcome = run(second);
  EXPECT_EQ(outcome.phase, Phase::completed);
  EXPECT_EQ(outcome.trials, 1U);
  EXPECT_TRUE(second.forms.empty()) << "was asked before";
  EXPECT_EQ(second.attempts.front(), first.attempts.back());
  EXPECT_EQ(
      value("SELECT group_concat(trial || ' ' || attempt) FROM (SELECT trial, attempt FROM attempt"
            " ORDER BY trial, attempt)"),
      "0 1,1 1,2 1,2 2")
      << "it was about to begin";
  EXPECT_EQ(value("SELECT count(*) FROM event AS a JOIN event AS b"
                  " ON b.sequence = a.sequence + 1 WHERE b.time_ns < a.time_ns"),
            "0")
      << "the session's clock goes on";
}

}  // namespace
}  // namespace foveola::study
