#include "study/participant/answers.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

const std::vector<Question> questions = {
    {.id = "age", .kind = QuestionKind::number, .minimum = 18, .maximum = 99},
    {.id = "gender",
     .kind = QuestionKind::choice,
     .options = {{"female", 5.0}, {"male", 1.0}, {"another", std::nullopt}}},
    {.id = "games", .kind = QuestionKind::likert, .minimum = 1, .maximum = 5},
    {.id = "hand", .kind = QuestionKind::choice, .options = {{"left", 0.0}, {"right", {}}}},
    {.id = "name_a_colour", .kind = QuestionKind::text},
    {.id = "comments", .kind = QuestionKind::text, .required = false}};

/// Everything that so many people answered to the question of this index.
std::set<std::variant<double, std::string>> given_answers(std::size_t question) {
  Pcg32 random(2);
  std::set<std::variant<double, std::string>> given;
  for (int person = 0; person < 1000; ++person) {
    given.insert(draw_answers(questions, random).at(question).value);
  }
  return given;
}

TEST(Answers, AreGoodOnesToEachQuestionThatNeedsOne) {
  Pcg32 random(1);
  for (int person = 0; person < 1000; ++person) {
    const std::vector<Answer> answers = draw_answers(questions, random);
    ASSERT_EQ(answers.size(), 5U);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      EXPECT_EQ(answers[i].question, questions[i].id);
      EXPECT_EQ(fault_of(questions[i], answers[i].value), "");
    }
  }
}

using Values = std::set<std::variant<double, std::string>>;

TEST(Answers, UseTheWholeScaleAndEveryOptionButOnlyTwoOfGender) {
  EXPECT_EQ(given_answers(1), (Values{1.0, 5.0}));
  EXPECT_EQ(given_answers(2), (Values{1.0, 2.0, 3.0, 4.0, 5.0}));
  EXPECT_EQ(given_answers(3), (Values{0.0, "right"}));
  EXPECT_GT(given_answers(0).size(), 50U);
}

}  // namespace
}  // namespace foveola::study
