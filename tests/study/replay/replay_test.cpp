#include "study/replay/replay.h"

#include <stdexcept>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/files/digest.h"
#include "study/record/write/recorders.h"
#include "study/simulation/rendered_attempt.h"
#include "study/simulation/virtual_session.h"
#include "tests/matchers.h"
#include "tests/study/participant/fake_participant.h"
#include "tests/study/record/small_study.h"
#include "tests/study/simulation/small_wall.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

using ::testing::Field;

/// Two scenes, one second for each mark, and half a one in a catch trial.
std::string two_walls(const std::string& mark_timeout = "1.000000") {
  std::string text = wall_protocol_text(20'000, 1.0);
  text.replace(text.find("[\"wall\"]"), 8, "[\"wall\", \"yard\"]");
  text.replace(text.find("1.000000"), 8, mark_timeout);
  return text + "[catch_trials]\ncount = 1\ntimeout_s = 0.5\n";
}

/// The program's, until it dies instead of recording another event.
class DyingRecorder final : public SessionRecorder {
 public:
  DyingRecorder(StudyStore& store, std::int64_t session, int events)
      : recorder_(store, session), events_left_(events) {}

  std::future<void> record(SessionEntry entry) override {
    if (std::holds_alternative<EventEntry>(entry) && --events_left_ < 0) {
      throw std::runtime_error("died");
    }
    return recorder_.record(std::move(entry));
  }

 private:
  StoreRecorder recorder_;
  int events_left_;
};

class ReplayTest : public ::testing::Test {
 protected:
  ReplayTest() {
    for (const char* name : {"wall", "yard"}) {
      stages_[name] = std::make_unique<SceneStage>(source_of(name), workers_);
    }
    participant_.sees_in_blackness = false;
  }

  SceneSource source_of(const std::string& name) const {
    SceneSource source = wall_with_a_square(folder_);
    source.name = name;
    return source;
  }

  SessionFacts facts() const {
    SessionFacts facts = facts_of("P1");
    facts.seed = 5;
    facts.design_row = 0;
    facts.build = build_info();
    facts.machine = machine_info();
    facts.scenes = shown_scenes(stages_);
    return facts;
  }

  /// Takes part, from where the session is, until it is over, stopped, or dead.
  Phase take_part(int events = 1'000) {
    session_ = session_ ? session_ : store_.begin_session(facts(), plan_);
    DyingRecorder recorder(store_, *session_, events);
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
                           plan_, participant_,
                           position_after(procedure_of(protocol_, plan_),
                                          store_.events_of(*session_), "participant P1"));
    return session.run().phase;
  }

  void begin_trial(std::size_t trial) {
    if (trial == stop_in_trial_) {
      stop_.request_stop();
    }
  }

  ReplayReport replay(std::optional<std::size_t> trial = {}, std::optional<int> attempt = {}) {
    return replay_session({.database = path_,
                           .participant = "P1",
                           .trial = trial,
                           .attempt = attempt,
                           .folder = folder_.path()},
                          [this](const std::string& name, const auto& /*folder*/) {
                            loaded_.push_back(name);
                            return source_of(name);
                          },
                          {});
  }

  /// Replays it all, and expects it to be the same. Returns its attempts, as "trial.attempt".
  std::vector<std::string> same_attempts() {
    const ReplayReport report = replay();
    EXPECT_EQ(report.approximate, "");
    EXPECT_EQ(report.difference, "");
    std::vector<std::string> attempts;
    for (const ReplayedAttempt& attempt : report.attempts) {
      attempts.push_back(fmt::format("{}.{}", attempt.trial, attempt.attempt));
      EXPECT_EQ(attempt.hashes, attempt.frames > 0 ? 1U : 0U) << attempts.back();
      EXPECT_FALSE(attempt.first_difference) << attempts.back();
    }
    return attempts;
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "study.sqlite";
  Protocol protocol_ = load_protocol(folder_.write("wall.toml", two_walls()));
  Plan plan_ = {{.scene = "wall", .method = "od"},
                {.scene = "wall", .method = "od", .kind = TrialKind::catch_trial},
                {.scene = "yard", .method = "fv", .scene_position = 1}};
  Workers workers_{1};
  SceneStages stages_;
  StudyStore store_{path_, protocol_};
  std::optional<std::int64_t> session_;
  FakeParticipant participant_;
  std::stop_source stop_;
  std::optional<std::size_t> stop_in_trial_;
  std::vector<std::string> loaded_;
};

TEST_F(ReplayTest, AWholeSessionIsMadeAgain) {
  participant_.retimed_turn = 1;
  ASSERT_EQ(take_part(), Phase::completed);
  EXPECT_THAT(same_attempts(), ElementsAre("0.1", "0.2", "1.1", "2.1"));
  EXPECT_THAT(replay().attempts, Each(Field(&ReplayedAttempt::frames, testing::Gt(0U))));
  EXPECT_THAT(replay({}, 2).attempts, ElementsAre(Field(&ReplayedAttempt::trial, 0U)));
}

// The films are of the filtered gaze.
TEST_F(ReplayTest, ASessionWhoseGazeWasFilteredIsMadeAgain) {
  protocol_.tracker.filter = {.one_euro = OneEuroSettings{}, .extrapolate_s = 0.1};
  participant_.gaze_deg_per_s = 20.0;
  ASSERT_EQ(take_part(), Phase::completed);
  EXPECT_THAT(same_attempts(), ElementsAre("0.1", "1.1", "2.1"));
}

TEST_F(ReplayTest, OnlyWhatIsChosenIsRendered) {
  take_part();
  const ReplayReport report = replay(2);
  ASSERT_THAT(report.attempts, SizeIs(1));
  EXPECT_EQ(report.attempts.front().trial, 2U);
  EXPECT_EQ(report.attempts.front().hashes, 1U);
  EXPECT_THAT(loaded_, ElementsAre("yard"));
}

TEST_F(ReplayTest, AnInterruptedSessionIsMadeAgainAsItWentOn) {
  stop_in_trial_ = 2;
  ASSERT_EQ(take_part(), Phase::interrupted);
  EXPECT_THAT(same_attempts(), ElementsAre("0.1", "1.1", "2.1"));
  stop_ = std::stop_source();
  stop_in_trial_.reset();
  ASSERT_EQ(take_part(), Phase::completed);
  EXPECT_THAT(same_attempts(), ElementsAre("0.1", "1.1", "2.1", "2.2"));
}

// Between trials, before the first frame, between marks and before the rating.
TEST_F(ReplayTest, ASessionWhoseProgramDiedIsMadeAgain) {
  constexpr int deaths = 8;
  for (int events = 1; events <= deaths; ++events) {
    EXPECT_THROW(take_part(events), std::runtime_error);
    const bool has_attempt = query(path_, "SELECT count(*) > 0 FROM attempt") == "1";
    if (has_attempt) {
      same_attempts();
    }
  }
  ASSERT_EQ(take_part(), Phase::completed);
  EXPECT_THAT(same_attempts(), Contains("2.1"));
  EXPECT_EQ(query(path_, "SELECT count(*) FROM event WHERE type = 'interrupted'"),
            std::to_string(deaths));
}

TEST_F(ReplayTest, ASessionThatTheParticipantEndedIsMadeAgain) {
  participant_.withdraws_before = 1;
  ASSERT_EQ(take_part(), Phase::withdrawn);
  EXPECT_THAT(same_attempts(), ElementsAre("0.1"));
}

TEST_F(ReplayTest, AnExcludedSessionIsMadeAgain) {
  PlayedSession session(store_, facts(), plan_, protocol_);
  session.happen(ms(0), SessionStarted{});
  session.choose_and_start(ms(20));
  session.happen(ms(30), FirstFramePresented{ms(30)});
  session.happen(ms(40), Marked{ms(40)});
  session.happen(ms(50), Excluded{"fell asleep"});
  EXPECT_THAT(same_attempts(), ElementsAre("0.1"));
}

TEST_F(ReplayTest, TheFirstFrameWasPresentedWhenItsRowSays) {
  PlayedSession session(store_, facts(), plan_, protocol_);
  session.happen(ms(0), SessionStarted{});
  session.choose_and_start(ms(20));
  StoreRecorder recorder(store_, session.id());
  recorder.record(FrameChunk{.frames = {{.time = ms(25), .presented = ms(31)}}});
  session.happen(ms(30), FirstFramePresented{ms(30)});
  EXPECT_THAT(replay().difference, HasSubstr("makes first_frame_presented {\"time_ns\":31000000}"));
}

// The oldest files do not keep it: there, a frame is presented when it is begun.
TEST_F(ReplayTest, WhereThatIsNotKeptTheEventIsTrusted) {
  PlayedSession session(store_, facts(), plan_, protocol_);
  session.happen(ms(0), SessionStarted{});
  session.choose_and_start(ms(20));
  StoreRecorder recorder(store_, session.id());
  recorder.record(FrameChunk{.frames = {{.time = ms(25), .presented = ms(25)}}});
  session.happen(ms(30), FirstFramePresented{ms(30)});
  EXPECT_EQ(replay().difference, "");
}

// The notes of a moment may come between a deadline and its time-out.
TEST_F(ReplayTest, TheOrderOfTheRecordCounts) {
  PlayedSession session(store_, facts(), plan_, protocol_);
  session.happen(ms(0), SessionStarted{});
  session.choose_and_start(ms(20));
  session.happen(ms(30), FirstFramePresented{ms(30)});
  session.happen(ms(1035), NoteWritten{"the window is hidden"});
  session.happen(ms(1030), TimedOut{ms(1030)});
  session.happen(ms(1030), TimedOut{ms(1030)});
  session.happen(ms(1040), PauseRequested{});
  session.happen(ms(2000), Resumed{});
  EXPECT_THAT(same_attempts(), ElementsAre("0.1"));
}

TEST_F(ReplayTest, AnAmendedTimeOutIsTheOneOfItsRun) {
  const std::string amended = two_walls("0.800000");
  PlayedSession session(store_, facts(), plan_, protocol_);
  session.happen(ms(0), SessionStarted{});
  session.choose_and_start(ms(20));
  session.happen(ms(30), FirstFramePresented{ms(30)});
  session.happen(ms(1030), TimedOut{ms(1030)});
  session.happen(ms(1050), Interrupted{});
  session.happen(ms(1050), NoteWritten{"goes on with another screen"});
  session.happen(ms(1050), NoteWritten{note_of({.sha256 = sha256(std::string_view(amended)),
                                                .changed = {"timing.mark_timeout_s"},
                                                .text = amended})});
  session.happen(ms(1050), Resumed{});
  session.happen(ms(1060), TrialStarted{});
  session.happen(ms(2000), FirstFramePresented{ms(2000)});
  session.happen(ms(2800), TimedOut{ms(2800)});
  session.happen(ms(2800), TimedOut{ms(2800)});
  session.happen(ms(4000), rated(3));
  EXPECT_THAT(same_attempts(), ElementsAre("0.1", "0.2"));
}

class ChangedRecord : public ReplayTest {
 protected:
  /// What is said of a session in which `set` is set in the first event of this type.
  std::string difference(const std::string& type, const std::string& set) {
    fs::remove(changed_);
    store_.back_up(changed_);
    tamper(changed_, fmt::format("UPDATE event SET {} WHERE sequence = {}", set, number_of(type)));
    report_ = replay_session(
        {.database = changed_, .participant = "P1", .folder = folder_.path()},
        [this](const std::string& name, const auto& /*folder*/) { return source_of(name); }, {});
    EXPECT_THAT(report_.difference, StartsWith(fmt::format("event {} ", number_of(type))));
    EXPECT_THAT(report_.difference, Not(HasSubstr("\n")));
    return report_.difference;
  }

  std::string number_of(const std::string& type) const {
    return query(path_, "SELECT min(sequence) FROM event WHERE type = '" + type + "'");
  }

  ReplayReport report_;
  fs::path changed_ = folder_ / "changed.sqlite";
};

TEST_F(ChangedRecord, AnEventThatTheDriverMakesOtherwiseIsNamed) {
  ASSERT_EQ(take_part(), Phase::completed);
  const auto time_set = [](const std::string& time) {
    return fmt::format("payload = '{{\"time_ns\":{0}}}', time_ns = {0}", time);
  };
  const auto first_time = [this](const std::string& type) {
    return query(path_, "SELECT time_ns FROM event WHERE type = '" + type + "' LIMIT 1");
  };
  const std::string deadline = first_time("timed_out");
  for (const char* change : {" - 1", " - 100000000"}) {
    const std::string time = query(path_, "SELECT " + deadline + change);
    EXPECT_EQ(
        difference("timed_out", time_set(time)),
        fmt::format("event {0} is recorded as timed_out {{\"time_ns\":{1}}} at {1} ns, but the "
                    "replayed session makes timed_out {{\"time_ns\":{2}}} at {2} ns",
                    number_of("timed_out"), time, deadline));
    EXPECT_THAT(report_.attempts, SizeIs(3)) << "it goes on by the record";
  }
  EXPECT_THAT(difference("first_frame_presented", time_set("1050000001")),
              HasSubstr("makes first_frame_presented {\"time_ns\":1050000000}"));
  EXPECT_THAT(difference("marked", "time_ns = time_ns + 1"), HasSubstr("makes marked "));
}

// The time-out of the mark that was made is later than the next one, which then cannot be made.
TEST_F(ChangedRecord, WhatCannotFollowIsReplayedUntilThen) {
  ASSERT_EQ(take_part(), Phase::completed);
  EXPECT_THAT(difference("marked", "type = 'timed_out'"),
              HasSubstr("makes timed_out {\"time_ns\":2050000000}"));
  EXPECT_THAT(report_.attempts, IsEmpty());
}

}  // namespace
}  // namespace foveola::study
