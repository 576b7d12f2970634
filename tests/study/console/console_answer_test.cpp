#include "study/console/console_answer.h"

#include <gmock/gmock.h>

namespace foveola::study {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ConsoleAnswers : public ::testing::Test {
 protected:
  ConsoleAnswer answer(const std::string& line) const {
    return answer_to(
        line, {.phase = Phase::marking, .step = 1},
        {.agenda = {ConsentStep{}, TrialStep{.trial = 0}, QuestionnaireStep{"debrief"}}},
        {{.scene = "hall", .method = "od"}});
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
  EXPECT_EQ(event_of("withdraw"), "withdrawn");
  const auto note = answer("note it rings").event;
  EXPECT_EQ(std::get<NoteWritten>(note.value()).text, "it rings");
  const auto excluded = answer("exclude sees double").event;
  EXPECT_EQ(std::get<Excluded>(excluded.value()).reason, "sees double");
}

TEST_F(ConsoleAnswers, SomeAreQuestions) {
  EXPECT_THAT(answer("state").reply, HasSubstr("hall with od"));
  EXPECT_EQ(answer("next").reply, "questionnaire debrief");
  EXPECT_THAT(answer("help").reply, HasSubstr("withdraw"));
  EXPECT_FALSE(answer("state").event);
}

TEST_F(ConsoleAnswers, OneQuits) {
  EXPECT_TRUE(answer("quit").quits);
  EXPECT_FALSE(answer("quit").event);
}

TEST_F(ConsoleAnswers, WhatIsNotKnownIsAskedBack) {
  EXPECT_THAT(answer("lunch").reply, HasSubstr("What is 'lunch'?"));
  EXPECT_EQ(event_of(""), "");
}

}  // namespace
}  // namespace foveola::study
