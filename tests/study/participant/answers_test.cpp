#include "study/participant/answers.h"

#include <set>

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

const std::vector<Question> questions = {
    {.id = "age", .text = "How old are you?", .minimum = 18, .maximum = 99},
    {.id = "gender", .text = "Coded 1 or 5", .minimum = 1, .maximum = 5},
    {.id = "games", .text = "How often do you play?", .minimum = 1, .maximum = 5}};

TEST(Answers, AreOneToEachQuestionWithinItsRange) {
  Pcg32 random(1);
  for (int person = 0; person < 1000; ++person) {
    const std::vector<Answer> answers = draw_answers(questions, random);
    ASSERT_EQ(answers.size(), questions.size());
    for (std::size_t i = 0; i < answers.size(); ++i) {
      EXPECT_EQ(answers[i].question, questions[i].id);
      EXPECT_GE(answers[i].value, questions[i].minimum);
      EXPECT_LE(answers[i].value, questions[i].maximum);
    }
  }
}

TEST(Answers, UseTheWholeScaleButOnlyTheEndsOfGender) {
  Pcg32 random(2);
  std::set<int> genders;
  std::set<int> games;
  for (int person = 0; person < 1000; ++person) {
    const std::vector<Answer> answers = draw_answers(questions, random);
    genders.insert(answers[1].value);
    games.insert(answers[2].value);
  }
  EXPECT_EQ(genders, (std::set<int>{1, 5}));
  EXPECT_EQ(games, (std::set<int>{1, 2, 3, 4, 5}));
}

}  // namespace
}  // namespace foveola::study
