#include "study/person/prompts/prompt_state.h"

#include "tests/matchers.h"
#include "tests/study/person/prompts/prompt_session.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;
using test::PromptSession;

/// The titles of the notices that are to be read.
std::vector<std::string> titles(const PromptSession& session) {
  std::vector<std::string> titles;
  for (const ScreenPage& notice : session.prompt.notices) {
    titles.push_back(notice.title);
  }
  return titles;
}

std::string title_of(Notice notice, const PromptSession& session) {
  return notice_screen(notice, session.protocol.texts).title;
}

TEST(PromptStateTest, ASessionBeginsWithAWelcome) {
  PromptSession session;
  session.follow(SessionStarted{});
  EXPECT_THAT(titles(session), ElementsAre(title_of(Notice::welcome, session)));
}

TEST(PromptStateTest, AFormIsThereUntilItsAnswersAreKept) {
  PromptSession session;
  session.prepare(AskForConsent{});
  EXPECT_TRUE(is_form_shown(session.prompt, Phase::consent));
  session.follow(ConsentGiven{});
  EXPECT_FALSE(is_form_shown(session.prompt, Phase::consent));
}

TEST(PromptStateTest, AfterAPauseTheAnswersSoFarAreStillThere) {
  PromptSession session;
  session.prepare(AskQuestionnaire{"background"});
  test::type(*session.prompt.form, U"20");
  session.prepare(ShowPause{});
  session.prepare(AskQuestionnaire{"background"});
  EXPECT_EQ(session.prompt.form->screen().fields.at(0).typed, "20");
  session.prepare(AskQuestionnaire{"debrief"});
  EXPECT_EQ(session.prompt.form->screen().fields.at(0).typed, "");
}

TEST(PromptStateTest, AFormWaitsForConfirmationsAndNotices) {
  PromptSession session;
  session.prepare(AskQuestionnaire{"background"});
  ASSERT_TRUE(is_form_shown(session.prompt, Phase::questionnaire));
  EXPECT_FALSE(is_form_shown(session.prompt, Phase::paused));
  session.prompt.confirmation.emplace(Confirmed::stopping, session.protocol.texts);
  EXPECT_FALSE(is_form_shown(session.prompt, Phase::questionnaire));
  session.prompt.confirmation.reset();
  session.follow(SessionStarted{});
  EXPECT_FALSE(is_form_shown(session.prompt, Phase::questionnaire));
}

TEST(PromptStateTest, WhatAFormSaysDependsOnWhatWasAsked) {
  PromptSession session;
  session.prepare(AskQuestionnaire{"background"});
  test::type(*session.prompt.form, U"20");
  test::press(*session.prompt.form, {FormKey::enter, FormKey::enter});
  const Event answered =
      event_of_form(session.prompt, Phase::questionnaire, session.protocol).value();
  EXPECT_EQ(std::get<QuestionnaireAnswered>(answered).questionnaire, "background");
  EXPECT_EQ(std::get<QuestionnaireAnswered>(answered).answers.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<Rated>(
      event_of_form(session.prompt, Phase::rating, session.protocol).value()));
}

TEST(PromptStateTest, OnlyWhoAgreesGivesConsent) {
  PromptSession session;
  for (const auto& [choice, agrees] : {std::pair{U'1', true}, std::pair{U'2', false}}) {
    session.prepare(AskForConsent{});
    Form& form = *session.prompt.form;
    test::press(form, {FormKey::enter});
    form.follow(choice);
    test::press(form, {FormKey::enter});
    ASSERT_TRUE(form.is_submitted());
    const std::optional<Event> event =
        event_of_form(session.prompt, Phase::consent, session.protocol);
    EXPECT_EQ(event && std::holds_alternative<ConsentGiven>(*event), agrees);
  }
}

TEST(PromptStateTest, TheReactionTestIsExplainedOnce) {
  PromptSession session;
  session.seen = {.phase = Phase::reaction, .presses_left = 2};
  session.prepare(AskForPress{});
  EXPECT_EQ(titles(session).size(), 1U);
  session.follow(ReactionPressed{.shown = 2s, .time = 1s});
  session.prepare(AskForPress{});
  EXPECT_EQ(titles(session).size(), 1U) << "a false start";
  session.follow(ReactionPressed{.shown = 2s, .time = 3s});
  session.seen.presses_left = 1;
  session.prepare(AskForPress{});
  EXPECT_EQ(titles(session).size(), 1U);
}

TEST(PromptStateTest, NoticesComeBeforeTheObjectOrElseBeforeTheTrial) {
  PromptSession session;
  session.procedure.agenda = {TrialStep{.trial = 0}, TrialStep{.trial = 1}};
  session.seen = {.phase = Phase::choosing_object, .step = 1};
  session.prepare(AskForObject{});
  session.prepare(AskWhetherReady{});
  EXPECT_THAT(titles(session), ElementsAre(title_of(Notice::next_scene, session)));

  PromptSession without_choice;
  without_choice.seen = {.phase = Phase::ready, .step = 1};
  without_choice.prepare(AskWhetherReady{});
  EXPECT_EQ(titles(without_choice).size(), 1U);
}

TEST(PromptStateTest, ARatingComesWhenItIsWantedAndWasLookedAround) {
  PromptSession session;
  session.prompt.wants_to_rate = true;  // of the trial before
  session.seen = {.phase = Phase::rating};
  session.prepare(AskForRating{});
  session.prompt.look_around_until = 14s;
  EXPECT_FALSE(begin_rating(session.prompt, session.protocol, 20s)) << "not wanted";
  session.prompt.wants_to_rate = true;
  EXPECT_FALSE(begin_rating(session.prompt, session.protocol, 13900ms)) << "looks around";
  EXPECT_TRUE(begin_rating(session.prompt, session.protocol, 14s));
  EXPECT_TRUE(is_form_shown(session.prompt, Phase::rating));
  EXPECT_FALSE(begin_rating(session.prompt, session.protocol, 15s)) << "it is there";
  session.prepare(StopRendering{});
  EXPECT_FALSE(is_form_shown(session.prompt, Phase::rating));
}

TEST(PromptStateTest, AValidationBeginsOnceUntilItIsAskedForAgain) {
  PromptSession session;
  const ViewGeometry geometry{.horizontal_fov_deg = 60.0, .vertical_fov_deg = 60.0};
  const auto begin = [&](Nanoseconds start) {
    begin_validation(session.prompt, *session.protocol.tracker.validation, geometry, start);
  };
  begin(0s);
  const Vec3 first = *session.prompt.validation->target();
  session.prompt.validation->update(4s, {});  // nothing was seen of it
  const Vec3 second = *session.prompt.validation->target();
  ASSERT_NE(second, first);
  begin(5s);
  EXPECT_EQ(*session.prompt.validation->target(), second);
  session.prepare(ValidateGaze{});
  EXPECT_FALSE(session.prompt.validation);
  begin(6s);
  EXPECT_EQ(*session.prompt.validation->target(), first);
}

TEST(PromptStateTest, NoNoticeIsLeftInAPauseOrAtTheEnd) {
  for (const Effect& effect : {Effect(ShowPause{}), Effect(EndSession{})}) {
    PromptSession session;
    session.follow(SessionStarted{});
    session.prepare(effect);
    EXPECT_TRUE(session.prompt.notices.empty());
  }
}

}  // namespace
}  // namespace foveola::study
