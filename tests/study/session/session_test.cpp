#include "study/session/session.h"

#include <map>

#include "tests/matchers.h"
#include "tests/study/session/whole_procedure.h"

namespace foveola::study {
namespace {

SessionState after(const std::vector<Event>& events) {
  SessionState state;
  for (const Event& event : events) {
    const std::optional<Transition> next = step(whole_procedure(), state, event);
    EXPECT_TRUE(next) << name_of(event) << " was refused";
    state = next ? next->state : state;
  }
  return state;
}

/// The first events of `all_events`, until the session is in this phase.
std::vector<Event> until(Phase phase) {
  std::vector<Event> events;
  for (const Event& event : all_events()) {
    if (after(events).phase == phase) {
      break;
    }
    events.push_back(event);
  }
  EXPECT_EQ(after(events).phase, phase);
  return events;
}

std::vector<Event> operator+(std::vector<Event> events, const Event& event) {
  events.push_back(event);
  return events;
}

Transition last_step(const std::vector<Event>& before, const Event& event) {
  const auto transition = step(whole_procedure(), after(before), event);
  EXPECT_TRUE(transition) << name_of(event);
  return transition.value_or(Transition{});
}

bool is_refused(const std::vector<Event>& before, const Event& event) {
  return !step(whole_procedure(), after(before), event);
}

TEST(Session, GoesThroughItsAgenda) {
  std::vector<Phase> phases;
  SessionState state;
  for (const Event& event : all_events()) {
    const auto transition = step(whole_procedure(), state, event);
    ASSERT_TRUE(transition) << name_of(event) << " in " << name_of(state.phase);
    if (transition->state.phase != state.phase) {
      phases.push_back(transition->state.phase);
    }
    state = transition->state;
  }
  using enum Phase;
  EXPECT_THAT(phases, ElementsAre(consent, questionnaire, validation, reaction, choosing_object,
                                  ready, armed, marking, rating, ready, armed, marking, rating,
                                  questionnaire, completed));
  EXPECT_TRUE(state.is_over());
  EXPECT_EQ(state.step, whole_procedure().agenda.size());
}

TEST(Session, AnotherQuestionnaireThanWasAskedIsRefused) {
  EXPECT_TRUE(is_refused(until(Phase::questionnaire), QuestionnaireAnswered{"debrief", {}}));
}

TEST(Session, AGazeThatDoesNotPassIsValidatedAgainAndThenRefused) {
  const std::vector<Event> validating = until(Phase::validation);
  const Transition again = last_step(validating, GazeValidated{});
  EXPECT_EQ(again.state.phase, Phase::validation);
  EXPECT_THAT(names_of(again.effects), ElementsAre("ValidateGaze"));
  const std::vector<Event> failed_once = validating + GazeValidated{};
  EXPECT_EQ(last_step(failed_once, GazeValidated{.passed = true}).state.phase, Phase::reaction);
  const Transition refused = last_step(failed_once, GazeValidated{});
  EXPECT_EQ(refused.state.phase, Phase::refused);
  EXPECT_TRUE(refused.state.is_over());
  EXPECT_THAT(names_of(refused.effects), ElementsAre("EndSession"));
}

TEST(Session, AFalseStartIsAskedForAgain) {
  const std::vector<Event> waiting = until(Phase::reaction);
  const Transition early = last_step(waiting, ReactionPressed{.shown = at(20), .time = at(10)});
  EXPECT_EQ(early.state, after(waiting));
  EXPECT_THAT(names_of(early.effects), ElementsAre("AskForPress"));
  const Event good = ReactionPressed{.shown = at(20), .time = at(20)};
  EXPECT_EQ(last_step(waiting, good).state.phase, Phase::reaction) << "one of two";
  EXPECT_EQ(last_step(waiting + good, good).state.phase, Phase::choosing_object);
}

TEST(Session, AnObjectMustBeNamedAndStaysForTheSceneIfTheAgendaSaysSo) {
  EXPECT_TRUE(is_refused(until(Phase::choosing_object), ObjectChosen{""}));
  const SessionState second = after(events_of_first_trial() + all_events()[11]);
  EXPECT_EQ(trial_of(whole_procedure(), second), 1U);
  EXPECT_EQ(second.phase, Phase::ready);
  EXPECT_EQ(second.object, "vase");
}

TEST(Session, MarksCannotPrecedeWhatTheyFollow) {
  const std::vector<Event> marking = until(Phase::armed) + FirstFramePresented{at(9)};
  EXPECT_TRUE(is_refused(marking, Marked{at(8)}));
  EXPECT_TRUE(is_refused(marking, TimedOut{at(8)}));
  EXPECT_TRUE(is_refused(marking + Marked{at(20)}, Marked{at(19)}));
  EXPECT_EQ(last_step(marking + Marked{at(20)}, Marked{at(20)}).state.phase, Phase::rating);
}

TEST(Session, MarksAreAcknowledgedAndTimeOutsAreNot) {
  const std::vector<Event> marking = until(Phase::marking);
  EXPECT_THAT(names_of(last_step(marking, Marked{at(100)}).effects),
              ElementsAre("AcknowledgeMark"));
  EXPECT_THAT(names_of(last_step(marking, TimedOut{at(100)}).effects), ElementsAre());
  EXPECT_THAT(names_of(last_step(marking + Marked{at(100)}, Marked{at(100)}).effects),
              ElementsAre("AcknowledgeMark", "AskForRating"));
  EXPECT_THAT(names_of(last_step(marking + Marked{at(100)}, TimedOut{at(100)}).effects),
              ElementsAre("AskForRating"));
}

TEST(Session, RatingsMustAnswerWhatIsAsked) {
  const std::vector<Event> rating = until(Phase::rating);
  const Answer three{"artifacts", 3.0};
  for (const std::vector<Answer>& bad :
       std::vector<std::vector<Answer>>{{},
                                        {{"artifacts", 0.0}},
                                        {{"artifacts", 6.0}},
                                        {{"artifacts", 2.5}},
                                        {{"artifacts", std::string("three")}},
                                        {{"other", 3.0}},
                                        {three, {"other", 3.0}},
                                        {three, three},
                                        {{"comment", std::string("fine")}}}) {
    EXPECT_TRUE(is_refused(rating, Rated{bad})) << testing::PrintToString(bad.size());
  }
  EXPECT_FALSE(is_refused(rating, Rated{{three}}));
  EXPECT_FALSE(is_refused(rating, Rated{{three, {"comment", std::string("fine")}}}));
}

TEST(Session, RetimingTakesTheWholeMethodAnewWithTheSameObject) {
  for (const std::vector<Event>& events :
       {until(Phase::marking), until(Phase::marking) + Marked{at(100)}, until(Phase::rating)}) {
    const Transition again = last_step(events, RetimeRequested{});
    EXPECT_THAT(names_of(again.effects), ElementsAre("StopRendering", "AskWhetherReady"));
    SessionState expected = after(until(Phase::ready));
    expected.attempt = 2;
    expected.timing = 2;
    EXPECT_EQ(again.state, expected);
  }
}

TEST(Session, APauseEndsAnAttemptButIsNoTiming) {
  for (const Phase phase : {Phase::armed, Phase::marking, Phase::rating}) {
    const Transition paused = last_step(until(phase), PauseRequested{});
    EXPECT_EQ(paused.state.phase, Phase::paused);
    EXPECT_THAT(names_of(paused.effects), ElementsAre("StopRendering", "ShowPause"));
    const Transition resumed = last_step(until(phase) + PauseRequested{}, Resumed{});
    EXPECT_THAT(names_of(resumed.effects), ElementsAre("AskWhetherReady"));
    SessionState expected = after(until(Phase::ready));
    expected.attempt = 2;
    EXPECT_EQ(resumed.state, expected);
  }
}

TEST(Session, ElsewhereAPauseLeadsBackToWhereItWas) {
  for (const Phase phase : {Phase::consent, Phase::questionnaire, Phase::validation,
                            Phase::reaction, Phase::choosing_object, Phase::ready}) {
    const std::vector<Event> before = until(phase);
    EXPECT_EQ(last_step(before + PauseRequested{}, Resumed{}).state, after(before));
    EXPECT_EQ(last_step(before + Interrupted{}, Resumed{}).state, after(before));
    EXPECT_EQ(last_step(before + PauseRequested{} + Interrupted{} + Interrupted{}, Resumed{}).state,
              after(before))
        << "the program died in the pause";
  }
  EXPECT_EQ(last_step({Interrupted{}}, Resumed{}).state, SessionState{});
}

TEST(Session, AnEndThatIsUndoneIsAPause) {
  for (const Phase phase :
       {Phase::consent, Phase::questionnaire, Phase::validation, Phase::reaction,
        Phase::choosing_object, Phase::ready, Phase::armed, Phase::marking, Phase::rating}) {
    const std::vector<Event> before = until(phase);
    const SessionState paused = after(before + PauseRequested{});
    for (const Event& end : {Event(Withdrawn{}), Event(Excluded{"a slip"})}) {
      const Transition undone = last_step(before + end, EndUndone{});
      EXPECT_EQ(undone.state, paused);
      EXPECT_THAT(names_of(undone.effects), ElementsAre("ShowPause"));
      EXPECT_EQ(after(before + PauseRequested{} + end + EndUndone{}), paused);
    }
    EXPECT_TRUE(is_refused(before, EndUndone{}));
    EXPECT_TRUE(is_refused(before + Withdrawn{} + EndUndone{}, EndUndone{})) << "twice";
  }
  EXPECT_TRUE(is_refused(all_events(), EndUndone{})) << "it is completed";
}

TEST(Session, ConsentIsAskedAnewAndLeadsBackToWhereItWas) {
  for (const Phase phase : {Phase::questionnaire, Phase::validation, Phase::reaction,
                            Phase::choosing_object, Phase::ready}) {
    const std::vector<Event> before = until(phase);
    const std::vector<Event> asked = before + Interrupted{} + ConsentAsked{} + Resumed{};
    EXPECT_EQ(after(asked).phase, Phase::consent);
    EXPECT_EQ(trial_of(whole_procedure(), after(asked)), std::nullopt);
    EXPECT_THAT(names_of(last_step(before + Interrupted{} + ConsentAsked{}, Resumed{}).effects),
                ElementsAre("AskForConsent"));
    EXPECT_EQ(last_step(asked, ConsentGiven{}).state, after(before));
    EXPECT_EQ(last_step(asked + PauseRequested{} + Resumed{}, ConsentGiven{}).state, after(before));
    EXPECT_EQ(after(asked + Withdrawn{}).phase, Phase::withdrawn);
    EXPECT_TRUE(is_refused(before, ConsentAsked{})) << "nobody would read it";
    EXPECT_TRUE(is_refused(asked + Interrupted{}, ConsentAsked{})) << "it is asked already";
  }
  EXPECT_TRUE(is_refused(until(Phase::consent) + Interrupted{}, ConsentAsked{}))
      << "none was given yet";
}

TEST(Session, TellsWhichTrialItIsIn) {
  const Procedure procedure = whole_procedure();
  EXPECT_EQ(trial_of(procedure, {}), std::nullopt);
  EXPECT_EQ(trial_of(procedure, after(until(Phase::reaction))), std::nullopt);
  EXPECT_EQ(trial_of(procedure, after(until(Phase::choosing_object))), 0U);
  EXPECT_EQ(trial_of(procedure, after(until(Phase::marking))), 0U);
  EXPECT_EQ(trial_of(procedure, after(until(Phase::marking) + PauseRequested{})), 0U);
  EXPECT_EQ(trial_of(procedure, after(until(Phase::reaction) + Interrupted{})), std::nullopt);
  EXPECT_EQ(trial_of(procedure, after(until(Phase::marking) + Withdrawn{})), std::nullopt);
}

TEST(Session, TakesWhatItKnowsFromTheProtocol) {
  Protocol protocol;
  protocol.marks = {{.id = "outline"}, {.id = "material"}, {.id = "shadow"}};
  protocol.ratings = {{.id = "artifacts"}};
  protocol.phases = {{.kind = PhaseEntry::Kind::consent}, {.kind = PhaseEntry::Kind::trials}};
  const Procedure procedure =
      procedure_of(protocol, {{.scene = "a", .method = "od"}, {.scene = "a", .method = "fv"}});
  EXPECT_EQ(procedure.marks, 3U);
  ASSERT_EQ(procedure.ratings.size(), 1U);
  EXPECT_EQ(procedure.ratings[0].id, "artifacts");
  EXPECT_EQ(procedure.agenda.size(), 3U);
}

TEST(Session, TheGazeGoesThroughTheCorrectionThatPassed) {
  const GazeCorrection correction{.azimuth = {1.0, 1.0, 0.0}};
  GazeValidated validated{.runs = {GazeRun{}, GazeRun{.correction = correction, .passed = true}},
                          .passed = true};
  ASSERT_TRUE(correction_after(validated));
  EXPECT_EQ(correction_after(validated)->azimuth, correction.azimuth);
  validated.passed = false;
  EXPECT_FALSE(correction_after(validated));
}

}  // namespace
}  // namespace foveola::study
