#include "study/console/console_command.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

class ConsoleAnswers : public ::testing::Test {
 protected:
  ConsoleAnswer answer(const std::string& line) const {
    return answer_to(line, {.participant = "P3",
                            .state = {.phase = Phase::marking, .step = 1},
                            .procedure = {.agenda = {ConsentStep{}, TrialStep{.trial = 0},
                                                     QuestionnaireStep{"debrief"}}},
                            .plan = {{.scene = "hall", .method = "od"}}});
  }

  /// The name of the event that a line asks for, if nothing else came of it.
  std::string event_of(const std::string& line) const {
    const ConsoleAnswer answer = this->answer(line);
    EXPECT_THAT(answer.reply, IsEmpty());
    EXPECT_FALSE(answer.quits);
    return answer.event ? name_of(*answer.event) : "";
  }
};

TEST_F(ConsoleAnswers, SomeLinesAreEvents) {
  EXPECT_EQ(event_of("pause"), "pause_requested");
  EXPECT_EQ(event_of("resume"), "resumed");
  EXPECT_EQ(event_of("retime"), "retime_requested");
  EXPECT_EQ(event_of("withdraw P3"), "withdrawn");
  EXPECT_EQ(event_of("undo"), "end_undone");
  const auto note = answer("note it rings").event;
  EXPECT_EQ(std::get<NoteWritten>(note.value()).text, "it rings");
  const auto excluded = answer("exclude P3 sees double").event;
  EXPECT_EQ(std::get<Excluded>(excluded.value()).reason, "sees double");
}

TEST_F(ConsoleAnswers, SomeAreQuestions) {
  EXPECT_THAT(answer("state").reply, HasSubstr("hall with od"));
  EXPECT_EQ(answer("next").reply, "questionnaire debrief");
  EXPECT_THAT(answer("help").reply, HasSubstr("withdraw"));
  EXPECT_FALSE(answer("state").event);
}

TEST_F(ConsoleAnswers, WhatEndsASessionNeedsItsParticipantsCode) {
  for (const char* line : {"withdraw P4", "withdraw p3", "exclude P4 sees double"}) {
    EXPECT_FALSE(answer(line).event) << line;
    EXPECT_THAT(answer(line).reply, HasSubstr("type the code P3"));
  }
  EXPECT_EQ(answer("withdraw").reply, "'withdraw' is incomplete; type withdraw CODE");
  EXPECT_THAT(answer("exclude sees").reply, HasSubstr("type exclude CODE REASON"));
}

TEST_F(ConsoleAnswers, OneQuits) {
  EXPECT_TRUE(answer("quit").quits);
  EXPECT_FALSE(answer("quit").event);
}

TEST_F(ConsoleAnswers, WhatIsNotKnownIsAskedBack) {
  EXPECT_THAT(answer("lunch").reply, HasSubstr("'lunch' is not a command"));
  EXPECT_EQ(event_of(""), "");
}

}  // namespace
}  // namespace foveola::study
