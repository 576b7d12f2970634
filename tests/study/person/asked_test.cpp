#include "study/person/asked.h"

#include <gmock/gmock.h>

#include "tests/study/person/asked_protocol.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;
using test::AskedSession;

/// The titles of the notices that are to be read.
std::vector<std::string> titles(const AskedSession& session) {
  std::vector<std::string> titles;
  for (const ScreenPage& notice : session.asked.notices) {
    titles.push_back(notice.title);
  }
  return titles;
}

std::string title_of(Notice notice, const AskedSession& session) {
  return notice_screen(notice, session.protocol.texts).title;
}

TEST(AskedTest, ASessionBeginsWithAWelcome) {
  AskedSession session;
  session.follow(SessionStarted{});
  EXPECT_THAT(titles(session), ::testing::ElementsAre(title_of(Notice::welcome, session)));
}

TEST(AskedTest, AFormIsThereUntilItsAnswersAreKept) {
  AskedSession session;
  session.prepare(AskForConsent{});
  EXPECT_TRUE(is_form_shown(session.asked, Phase::consent));
  session.follow(ConsentGiven{});
  EXPECT_FALSE(is_form_shown(session.asked, Phase::consent));
}

TEST(AskedTest, AfterAPauseTheAnswersSoFarAreStillThere) {
  AskedSession session;
  session.prepare(AskQuestionnaire{"background"});
  test::type(*session.asked.form, U"20");
  session.prepare(ShowPause{});
  session.prepare(AskQuestionnaire{"background"});
  EXPECT_EQ(session.asked.form->screen().fields.at(0).typed, "20");
  session.prepare(AskQuestionnaire{"debrief"});
  EXPECT_EQ(session.asked.form->screen().fields.at(0).typed, "");
}

TEST(AskedTest, AFormWaitsForDoubtsAndNotices) {
  AskedSession session;
  session.prepare(AskQuestionnaire{"background"});
  ASSERT_TRUE(is_form_shown(session.asked, Phase::questionnaire));
  EXPECT_FALSE(is_form_shown(session.asked, Phase::paused));
  session.asked.doubt = Doubt::stopping;
  EXPECT_FALSE(is_form_shown(session.asked, Phase::questionnaire));
  session.asked.doubt.reset();
  session.follow(SessionStarted{});
  EXPECT_FALSE(is_form_shown(session.asked, Phase::questionnaire));
}

TEST(AskedTest, WhatAFormSaysDependsOnWhatWasAsked) {
  AskedSession session;
  session.prepare(AskQuestionnaire{"background"});
  test::type(*session.asked.form, U"20");
  test::press(*session.asked.form, {FormKey::enter, FormKey::enter});
  const Event answered = event_of_form(session.asked, Phase::questionnaire);
  EXPECT_EQ(std::get<QuestionnaireAnswered>(answered).questionnaire, "background");
  EXPECT_EQ(std::get<QuestionnaireAnswered>(answered).answers.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<ConsentGiven>(event_of_form(session.asked, Phase::consent)));
  EXPECT_TRUE(std::holds_alternative<Rated>(event_of_form(session.asked, Phase::rating)));
}

TEST(AskedTest, TheReactionTestIsExplainedOnce) {
  AskedSession session;
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

TEST(AskedTest, WhatComesIsToldBeforeTheObjectOrElseBeforeTheTrial) {
  AskedSession session;
  session.procedure.agenda = {TrialStep{.trial = 0}, TrialStep{.trial = 1}};
  session.seen = {.phase = Phase::choosing_object, .step = 1};
  session.prepare(AskForObject{});
  session.prepare(AskWhetherReady{});
  EXPECT_THAT(titles(session), ::testing::ElementsAre(title_of(Notice::next_scene, session)));

  AskedSession without_choice;
  without_choice.seen = {.phase = Phase::ready, .step = 1};
  without_choice.prepare(AskWhetherReady{});
  EXPECT_EQ(titles(without_choice).size(), 1U);
}

TEST(AskedTest, ARatingComesWhenItIsWantedAndWasLookedAround) {
  AskedSession session;
  session.asked.wants_to_rate = true;  // of the trial before
  session.seen = {.phase = Phase::rating};
  session.prepare(AskForRating{}, 10s);
  EXPECT_FALSE(begin_rating(session.asked, session.protocol, 20s)) << "not wanted";
  session.asked.wants_to_rate = true;
  EXPECT_FALSE(begin_rating(session.asked, session.protocol, 13900ms)) << "4 s of looking around";
  EXPECT_TRUE(begin_rating(session.asked, session.protocol, 14s));
  EXPECT_TRUE(is_form_shown(session.asked, Phase::rating));
  EXPECT_FALSE(begin_rating(session.asked, session.protocol, 15s)) << "it is there";
  session.prepare(StopRendering{});
  EXPECT_FALSE(is_form_shown(session.asked, Phase::rating));
}

TEST(AskedTest, AValidationBeginsOnceUntilItIsAskedForAgain) {
  AskedSession session;
  const ViewGeometry geometry{.horizontal_fov_deg = 60.0, .vertical_fov_deg = 60.0};
  const auto begin = [&](Nanoseconds start) {
    begin_validation(session.asked, *session.protocol.tracker.validation, geometry, start);
  };
  begin(0s);
  const Vec3 first = *session.asked.validation->target();
  session.asked.validation->update(4s, {});  // nothing was seen of it
  const Vec3 second = *session.asked.validation->target();
  ASSERT_NE(second, first);
  begin(5s);
  EXPECT_EQ(*session.asked.validation->target(), second);
  session.prepare(ValidateGaze{});
  EXPECT_FALSE(session.asked.validation);
  begin(6s);
  EXPECT_EQ(*session.asked.validation->target(), first);
}

TEST(AskedTest, NoNoticeIsLeftInAPauseOrAtTheEnd) {
  for (const Effect& effect : {Effect(ShowPause{}), Effect(EndSession{})}) {
    AskedSession session;
    session.follow(SessionStarted{});
    session.prepare(effect);
    EXPECT_TRUE(session.asked.notices.empty());
  }
}

}  // namespace
}  // namespace foveola::study
