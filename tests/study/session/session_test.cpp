#include "study/session/session.h"

#include <functional>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola::study {
namespace {

constexpr Nanoseconds at(int milliseconds) { return std::chrono::milliseconds(milliseconds); }

Plan two_trials() {
  return {{.scene = "a", .method = "od", .scene_position = 0, .method_position = 0},
          {.scene = "a", .method = "fv", .scene_position = 0, .method_position = 1}};
}

/// One legal event of each kind, late enough for any state here.
std::vector<Event> every_event() {
  return {SessionStarted{},
          GazeValidated{.passed = true},
          BackgroundAnswered{},
          ObjectChosen{"vase"},
          FirstFramePresented{at(1000)},
          OutlineMarked{at(2000)},
          MaterialMarked{at(3000)},
          TimedOut{at(4000)},
          ArtifactsRated{3},
          RetimeRequested{},
          Interrupted{},
          Withdrawn{}};
}

SessionState after(const Plan& plan, const std::vector<Event>& events) {
  SessionState state;
  for (const Event& event : events) {
    const auto transition = step(plan, state, event);
    if (!transition) {
      ADD_FAILURE() << name_of(event) << " was refused in " << name_of(state.phase);
      return state;
    }
    state = transition->state;
  }
  return state;
}

const std::vector<Event> to_rating = {SessionStarted{},        BackgroundAnswered{},
                                      ObjectChosen{"vase"},    FirstFramePresented{at(1000)},
                                      OutlineMarked{at(2000)}, MaterialMarked{at(3000)}};

// The procedure as a table: what each phase accepts, and what follows. Written from the protocol of
// the study, not from the code.
TEST(Session, EveryEventInEveryPhase) {
  const std::map<Phase, std::map<std::string, Phase>> accepted = {
      {Phase::created, {{"session_started", Phase::background}}},
      {Phase::validation, {{"gaze_validated", Phase::background}}},
      {Phase::background, {{"background_answered", Phase::choosing_object}}},
      {Phase::choosing_object, {{"object_chosen", Phase::armed}}},
      {Phase::armed, {{"first_frame_presented", Phase::outline}}},
      {Phase::outline, {{"outline_marked", Phase::material}, {"timed_out", Phase::material}}},
      {Phase::material,
       {{"material_marked", Phase::rating},
        {"timed_out", Phase::rating},
        {"retime_requested", Phase::armed}}},
      {Phase::rating,
       {{"artifacts_rated", Phase::choosing_object}, {"retime_requested", Phase::armed}}},
      {Phase::completed, {}},
      {Phase::interrupted, {}},
      {Phase::withdrawn, {}},
      {Phase::refused, {}}};
  const Plan plan = two_trials();
  for (const auto& [phase, follows] : accepted) {
    SessionState state;
    state.phase = phase;
    for (const Event& event : every_event()) {
      const auto transition = step(plan, state, event);
      const std::string name = name_of(event);
      const bool ends_anywhere = (name == "interrupted" || name == "withdrawn") && !state.is_over();
      if (ends_anywhere) {
        ASSERT_TRUE(transition) << name << " in " << name_of(phase);
        EXPECT_STREQ(name_of(transition->state.phase), name.c_str());
      } else if (follows.contains(name)) {
        ASSERT_TRUE(transition) << name << " in " << name_of(phase);
        EXPECT_EQ(transition->state.phase, follows.at(name)) << name << " in " << name_of(phase);
      } else {
        EXPECT_FALSE(transition) << name << " in " << name_of(phase);
      }
    }
  }
}

// From every state that can be reached there is a way to the end.
TEST(Session, HasNoDeadEnds) {
  const Plan plan = two_trials();
  const std::function<bool(const SessionState&, int)> can_complete = [&](const SessionState& state,
                                                                         int steps) {
    if (state.phase == Phase::completed) {
      return true;
    }
    for (const Event& event : every_event()) {
      const auto next = step(plan, state, event);
      const bool ends_early = std::holds_alternative<Interrupted>(event) ||
                              std::holds_alternative<Withdrawn>(event) ||
                              std::holds_alternative<RetimeRequested>(event);
      if (next && !ends_early && steps > 0 && can_complete(next->state, steps - 1)) {
        return true;
      }
    }
    return false;
  };
  SessionState state;
  for (const Event& event : to_rating) {
    EXPECT_TRUE(can_complete(state, 20)) << name_of(state.phase);
    state = step(plan, state, event)->state;
  }
  EXPECT_TRUE(can_complete(step(plan, state, RetimeRequested{})->state, 20));
  EXPECT_TRUE(can_complete(after(plan, {SessionStarted{.validations = 1}}), 20));
}

TEST(Session, ValidatesTheGazeFirstIfItMust) {
  const Plan plan = two_trials();
  const auto started = step(plan, {}, SessionStarted{.validations = 2});
  ASSERT_TRUE(started);
  EXPECT_EQ(started->state.phase, Phase::validation);
  ASSERT_EQ(started->effects.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<ValidateGaze>(started->effects[0]));
  EXPECT_FALSE(step(plan, started->state, BackgroundAnswered{})) << "not before it passed";
  const auto passed = step(plan, started->state, GazeValidated{.passed = true});
  EXPECT_EQ(passed->state, after(plan, {SessionStarted{}})) << "as if there had been none";
  EXPECT_TRUE(std::holds_alternative<AskBackground>(passed->effects.at(0)));
}

TEST(Session, AGazeThatDoesNotPassIsValidatedAgainAndThenRefused) {
  const Plan plan = two_trials();
  const SessionState started = after(plan, {SessionStarted{.validations = 2}});
  const auto again = step(plan, started, GazeValidated{});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->state.phase, Phase::validation);
  EXPECT_TRUE(std::holds_alternative<ValidateGaze>(again->effects.at(0)));
  EXPECT_EQ(step(plan, again->state, GazeValidated{.passed = true})->state.phase,
            Phase::background);
  const auto refused = step(plan, again->state, GazeValidated{});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->state.phase, Phase::refused);
  EXPECT_TRUE(refused->state.is_over());
  ASSERT_EQ(refused->effects.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<EndSession>(refused->effects[0]));
}

TEST(Session, GoesThroughEveryTrialAndEnds) {
  const Plan plan = two_trials();
  std::vector<Event> events = to_rating;
  events.insert(events.end(),
                {ArtifactsRated{4}, ObjectChosen{"lamp"}, FirstFramePresented{at(5000)},
                 OutlineMarked{at(5100)}, MaterialMarked{at(5200)}, ArtifactsRated{1}});
  const SessionState end = after(plan, events);
  EXPECT_EQ(end.phase, Phase::completed);
  EXPECT_EQ(end.trial, 2U);
}

TEST(Session, RetimingStartsANewAttemptWithTheSameObject) {
  std::vector<Event> events = to_rating;
  events.emplace_back(RetimeRequested{});
  const SessionState state = after(two_trials(), events);
  EXPECT_EQ(state.phase, Phase::armed);
  EXPECT_EQ(state.attempt, 2);
  EXPECT_EQ(state.trial, 0U);
  EXPECT_EQ(state.object, "vase");
  EXPECT_EQ(state.first_frame, Nanoseconds(0));
  EXPECT_EQ(state.outline, Nanoseconds(0));
}

TEST(Session, MarksCannotPrecedeWhatTheyFollow) {
  const Plan plan = two_trials();
  const SessionState rendering = after(plan, {SessionStarted{}, BackgroundAnswered{},
                                              ObjectChosen{"x"}, FirstFramePresented{at(9)}});
  EXPECT_FALSE(step(plan, rendering, OutlineMarked{at(8)}));
  const SessionState marked = step(plan, rendering, OutlineMarked{at(20)})->state;
  EXPECT_FALSE(step(plan, marked, MaterialMarked{at(19)}));
  EXPECT_TRUE(step(plan, marked, MaterialMarked{at(20)}));
}

TEST(Session, RatingsLieBetweenOneAndFive) {
  const Plan plan = two_trials();
  const SessionState rating = after(plan, to_rating);
  for (const int value : {-1, 0, 6}) {
    EXPECT_FALSE(step(plan, rating, ArtifactsRated{value}));
  }
  for (const int value : {1, 5}) {
    EXPECT_TRUE(step(plan, rating, ArtifactsRated{value}));
  }
}

TEST(Session, AnObjectMustBeNamed) {
  const Plan plan = two_trials();
  const SessionState choosing = after(plan, {SessionStarted{}, BackgroundAnswered{}});
  EXPECT_FALSE(step(plan, choosing, ObjectChosen{""}));
}

TEST(Session, MarksAreAcknowledgedAndTimeOutsAreNot) {
  const Plan plan = two_trials();
  const SessionState rendering = after(plan, {SessionStarted{}, BackgroundAnswered{},
                                              ObjectChosen{"x"}, FirstFramePresented{at(0)}});
  const auto marked = step(plan, rendering, OutlineMarked{at(1)});
  ASSERT_EQ(marked->effects.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<AcknowledgeMark>(marked->effects[0]));
  EXPECT_TRUE(step(plan, rendering, TimedOut{at(1)})->effects.empty());
}

TEST(Session, RenderingIsStoppedWheneverItEnds) {
  const Plan plan = two_trials();
  const SessionState rating = after(plan, to_rating);
  for (const Event& event :
       std::vector<Event>{ArtifactsRated{3}, RetimeRequested{}, Interrupted{}, Withdrawn{}}) {
    const auto transition = step(plan, rating, event);
    ASSERT_TRUE(transition);
    ASSERT_FALSE(transition->effects.empty());
    EXPECT_TRUE(std::holds_alternative<StopRendering>(transition->effects.front()))
        << name_of(event);
  }
}

}  // namespace
}  // namespace foveola::study
