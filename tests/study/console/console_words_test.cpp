#include "study/console/console_words.h"

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

const Plan plan = {{.scene = "hall", .method = "od"},
                   {.scene = "hall", .method = "fv", .kind = TrialKind::catch_trial}};
const Procedure procedure{.agenda = {ConsentStep{}, TrialStep{.trial = 0}, TrialStep{.trial = 1},
                                     QuestionnaireStep{"debrief"}}};

TEST(ConsoleWords, SayWhatHappened) {
  Protocol protocol;
  protocol.marks = {{.id = "outline"}, {.id = "material"}};
  const SessionState after{.phase = Phase::rating, .mark = 2, .first_frame = 10s};
  const auto words = [&](const Event& event) { return words_for(event, after, protocol); };
  EXPECT_EQ(words(Marked{13214ms}), "material was marked after 3.214 s.");
  EXPECT_EQ(words(TimedOut{130s}), "material was not marked in 120 s.");
  EXPECT_EQ(words(NoteWritten{"it rings\nagain"}), "Note: it rings …");
  const std::string umlauts = "ü" + std::string(158, 'x') + "üü";
  EXPECT_EQ(words(NoteWritten{umlauts}), "Note: ü" + std::string(158, 'x') + "ü …");
  EXPECT_EQ(words(ObjectChosen{"lamp"}), "The object lamp was chosen.");
  EXPECT_EQ(words(ReactionPressed{.shown = 1s, .time = 1250ms}), "A reaction came after 250 ms.");
  EXPECT_EQ(words(ReactionPressed{.shown = 1s, .time = 900ms}), "A reaction came too early.");
  EXPECT_EQ(words(Excluded{"sees double"}), "The session was excluded: sees double.");
}

TEST(ConsoleWords, SayWhereTheSessionIs) {
  EXPECT_EQ(words_for({.phase = Phase::consent}, procedure, plan), "consent");
  EXPECT_EQ(
      words_for({.phase = Phase::marking, .step = 2, .attempt = 3, .timing = 2}, procedure, plan),
      "marking, trial 2 of 2 (catch): hall with fv, timing 2, attempt 3");
  EXPECT_EQ(words_for({.phase = Phase::completed, .step = 4}, procedure, plan), "completed");
}

TEST(ConsoleWords, WhoIsBlindReadsNoMethod) {
  const Plan told = without_methods(plan);
  for (const std::size_t step : {1U, 2U}) {
    const SessionState state{.phase = Phase::marking, .step = step};
    const std::string words =
        words_for(state, procedure, told) + words_for_next({.step = step - 1}, procedure, told);
    for (const char* method : {"od", "fv", "catch"}) {
      EXPECT_EQ(words.find(std::string(" ") + method), std::string::npos) << words;
      EXPECT_EQ(words.find(std::string("(") + method), std::string::npos) << words;
    }
  }
}

TEST(ConsoleWords, SayWhatComes) {
  EXPECT_EQ(words_for_next({.phase = Phase::consent}, procedure, plan),
            "trial 1 of 2: hall with od");
  EXPECT_EQ(words_for_next({.phase = Phase::rating, .step = 2}, procedure, plan),
            "questionnaire debrief");
  EXPECT_EQ(words_for_next({.phase = Phase::questionnaire, .step = 3}, procedure, plan),
            "the session's end");
}

}  // namespace
}  // namespace foveola::study
