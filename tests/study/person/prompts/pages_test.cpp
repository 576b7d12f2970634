#include "study/person/prompts/pages.h"

#include <gtest/gtest.h>

#include "tests/study/person/prompts/prompt_session.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;
using test::PromptSession;

/// Empty: the picture alone.
std::string title(const PromptSession& session, Nanoseconds now = 0s) {
  const std::optional<ScreenPage> page = page_of(session.prompt, session.context(), now);
  return page ? page->title : "";
}

PromptSession session_in(Phase phase) {
  PromptSession session;
  session.seen.phase = phase;
  return session;
}

std::string title_of(const ScreenPage& page) { return page.title; }

TEST(PagesTest, AConfirmationIsBeforeNoticesAndThoseAreBeforeThePhase) {
  PromptSession session = session_in(Phase::paused);
  const Texts& texts = session.protocol.texts;
  EXPECT_EQ(title(session), title_of(notice_screen(Notice::pause, texts)));
  session.follow(SessionStarted{});
  EXPECT_EQ(title(session), title_of(notice_screen(Notice::welcome, texts)));
  session.prompt.confirmation.emplace(Confirmed::stopping, texts);
  EXPECT_EQ(title(session), title_of(stopping_screen(texts)));
  session.prompt.confirmation.emplace(Confirmed::timing_again, texts);
  EXPECT_EQ(title(session), title_of(retiming_screen(texts)));
}

TEST(PagesTest, TheEndsDiffer) {
  const Texts texts = test::asking_protocol().texts;
  for (const auto& [phase, notice] :
       {std::pair(Phase::completed, Notice::goodbye),
        std::pair(Phase::withdrawn, Notice::withdrawn), std::pair(Phase::refused, Notice::refused),
        std::pair(Phase::excluded, Notice::interrupted), std::pair(Phase::created, Notice::loading),
        std::pair(Phase::interrupted, Notice::loading)}) {
    EXPECT_EQ(title(session_in(phase)), title_of(notice_screen(notice, texts))) << name_of(phase);
  }
}

TEST(PagesTest, AnArmedTrialShowsThePictureUnlessItWaitsForAGaze) {
  PromptSession session = session_in(Phase::armed);
  EXPECT_EQ(title(session), "");
  session.prompt.awaits_gaze = true;
  EXPECT_EQ(title(session), title_of(no_gaze_screen(session.protocol.texts)));
}

TEST(PagesTest, TargetsAreSeenAloneAndSaidBeforehand) {
  PromptSession session = session_in(Phase::validation);
  const Texts& texts = session.protocol.texts;
  session.seen.validations_left = 3;
  EXPECT_EQ(title(session), title_of(notice_screen(Notice::validation, texts)));
  session.seen.validations_left = 2;
  EXPECT_EQ(title(session), title_of(notice_screen(Notice::validation_again, texts)));
  begin_validation(session.prompt, *session.protocol.tracker.validation,
                   {.horizontal_fov_deg = 60.0, .vertical_fov_deg = 60.0}, 0s);
  EXPECT_EQ(title(session), "");
}

TEST(PagesTest, TheReactionTestShowsItsSignal) {
  PromptSession session = session_in(Phase::reaction);
  const Texts& texts = session.protocol.texts;
  EXPECT_EQ(title(session), title_of(reaction_wait_screen(texts)));
  session.follow(ReactionPressed{.shown = 2s, .time = 1s});
  EXPECT_EQ(title(session), title_of(reaction_early_screen(texts)));
  session.prompt.reaction.end_frame(*session.protocol.reaction, 0s);
  session.prompt.reaction.begin_frame(4s);
  const auto page = page_of(session.prompt, session.context(), 0s);
  EXPECT_TRUE(page->is_signal);
  EXPECT_FALSE(page->progress) << "nothing but the signal changes";
}

TEST(PagesTest, AMarkIsAcknowledgedForAMoment) {
  PromptSession session = session_in(Phase::marking);
  EXPECT_EQ(title(session, 10s), "");
  session.prepare(AcknowledgeMark{}, 10s);
  EXPECT_EQ(title(session, 10500ms), title_of(mark_taken_screen(1, 2, session.protocol.texts)));
  EXPECT_EQ(title(session, 11s), "");
}

TEST(PagesTest, ARatingIsPrecededByLookingAround) {
  PromptSession session = session_in(Phase::rating);
  const Texts& texts = session.protocol.texts;
  session.prepare(AcknowledgeMark{}, 10s);
  session.prepare(AskForRating{}, 10s);
  EXPECT_EQ(title(session, 10s), title_of(mark_taken_screen(2, 2, texts)));
  EXPECT_EQ(title(session, 12s), title_of(look_around_screen(texts)));
  session.prompt.wants_to_rate = true;
  begin_rating(session.prompt, session.protocol, 14s);
  EXPECT_EQ(title(session, 14s), title_of(rating_form(session.protocol.ratings, texts).screen()));
}

TEST(PagesTest, ATrialsPhasesLeaveThePicture) {
  PromptSession session = session_in(Phase::ready);
  session.seen.step = 1;
  session.protocol.texts["ready_title"] = "{trial} of {trials}";
  EXPECT_EQ(title(session), "2 of 2");
  EXPECT_FALSE(page_of(session.prompt, session.context(), 0s)->covers_picture);
  session.seen.timing = 2;
  session.prompt.object = {.name = "Lamp", .is_in_view = true};
  const auto first = [&] { return page_of(session.prompt, session.context(), 0s)->paragraphs[0]; };
  EXPECT_EQ(first(), "ready_again");
  session.prompt.timed_again = TimedAgain::gaze_elsewhere;
  EXPECT_EQ(first(), "ready_again_elsewhere");
  session.follow(TrialStarted{});
  EXPECT_EQ(first(), "ready_again");
  session.seen.phase = Phase::choosing_object;
  EXPECT_EQ(title(session), title_of(choosing_screen({}, session.protocol.texts)));
  session.seen.phase = Phase::armed;
  EXPECT_EQ(title(session), "");
}

TEST(PagesTest, PagesThatCoverThePictureSayHowFarItIs) {
  PromptSession session = session_in(Phase::paused);
  session.seen.step = 1;
  EXPECT_DOUBLE_EQ(page_of(session.prompt, session.context(), 0s)->progress.value(), 0.5);
  session.seen.phase = Phase::choosing_object;
  EXPECT_FALSE(page_of(session.prompt, session.context(), 0s)->progress);
}

}  // namespace
}  // namespace foveola::study
