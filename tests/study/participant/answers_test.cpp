#include "study/participant/answers.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "tests/study/participant/moments.h"

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

constexpr Background usual{.age_mean_years = 30.0,
                           .age_deviation_years = 10.0,
                           .first_gender_part = 0.5,
                           .scale_mean_part = 0.4,
                           .scale_deviation_part = 0.3};

using Values = std::set<std::variant<double, std::string>>;

/// Everything that so many people answered to the question of this index.
Values given_answers(std::size_t question) {
  Pcg32 random(2);
  Values given;
  for (int person = 0; person < 1000; ++person) {
    given.insert(draw_answers(questions, usual, random).at(question).value);
  }
  return given;
}

TEST(Answers, AreGoodOnesToEachQuestionThatNeedsOne) {
  Pcg32 random(1);
  for (int person = 0; person < 1000; ++person) {
    const std::vector<Answer> answers = draw_answers(questions, usual, random);
    ASSERT_EQ(answers.size(), 5U);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      EXPECT_EQ(answers[i].question, questions[i].id);
      EXPECT_EQ(fault_of(questions[i], answers[i].value), "");
    }
  }
}

TEST(Answers, UseTheWholeScaleAndEveryOptionButOnlyTwoOfGender) {
  EXPECT_EQ(given_answers(1), (Values{1.0, 5.0}));
  EXPECT_EQ(given_answers(2), (Values{1.0, 2.0, 3.0, 4.0, 5.0}));
  EXPECT_EQ(given_answers(3), (Values{0.0, "right"}));
  EXPECT_GT(given_answers(0).size(), 30U);
}

constexpr std::uint32_t answerers = 20'000;

Moments moments_of_answers(const Question& question, const Background& background) {
  Pcg32 random(3);
  return moments(answerers, [&](std::uint32_t) {
    return std::get<double>(draw_answers({question}, background, random).at(0).value);
  });
}

// Rounding to whole years adds 1/12 to the variance.
TEST(Answers, AgesHaveTheMeanAndTheDeviationThatAreAskedFor) {
  const Question age{.id = "age", .kind = QuestionKind::number, .minimum = 0, .maximum = 150};
  const Moments ages =
      moments_of_answers(age, {.age_mean_years = 41.0, .age_deviation_years = 5.0});
  EXPECT_NEAR(ages.mean, 41.0, 4.0 * 5.0 / std::sqrt(20'000.0));
  EXPECT_NEAR(ages.deviation, std::sqrt(25.0 + 1.0 / 12.0), 0.1);
}

TEST(Answers, ScalesHaveThemAsPartsOfTheirRange) {
  const Question wide{.id = "wide", .kind = QuestionKind::number, .minimum = 100, .maximum = 1100};
  const Moments answers =
      moments_of_answers(wide, {.scale_mean_part = 0.5, .scale_deviation_part = 0.1});
  EXPECT_NEAR(answers.mean, 600.0, 4.0 * 100.0 / std::sqrt(20'000.0));
  EXPECT_NEAR(answers.deviation, 100.0, 2.0);
}

}  // namespace
}  // namespace foveola::study
