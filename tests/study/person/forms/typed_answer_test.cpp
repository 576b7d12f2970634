#include "study/person/forms/typed_answer.h"

#include "tests/matchers.h"
#include "tests/study/person/forms/typing.h"

namespace foveola::study {
namespace {

Question many_points() {
  return {.id = "percent", .text = "How much?", .minimum = 0.0, .maximum = 100.0};
}

/// The answers of a form that hands have filled in by keys.
std::vector<Answer> typed_into_a_form(const std::vector<Question>& questions,
                                      const std::vector<Answer>& answers) {
  Form form({.title = "Form", .intro = {"Read this."}, .questions = questions}, {});
  while (!form.is_submitted()) {
    if (const Question* question = form.question()) {
      for (const FormInput& input : typed_answer(*question, answers)) {
        EXPECT_TRUE(form.follow(input)) << question->id;
      }
    }
    EXPECT_TRUE(form.follow(FormKey::enter));
  }
  return form.answers();
}

TEST(TypedAnswer, FillsInAForm) {
  const std::vector<Answer> answers = {
      {"age", 34.0}, {"gender", 1.0}, {"experience", 4.0}, {"percent", 55.0}, {"comments", "none"}};
  EXPECT_EQ(typed_into_a_form(
                {test::age(), test::gender(), test::experience(), many_points(), test::comments()},
                answers),
            answers);
}

TEST(TypedAnswer, OptionsWithoutANumberAreKnownByTheirWords) {
  const std::vector<Answer> answers = {{"gender", "other"}};
  EXPECT_EQ(typed_into_a_form({test::gender()}, answers), answers);
}

TEST(TypedAnswer, WhatIsNotAnsweredIsLeftOut) {
  EXPECT_THAT(typed_answer(test::comments(), {{"age", 20.0}}), IsEmpty());
  EXPECT_THAT(typed_into_a_form({test::comments()}, {}), IsEmpty());
}

TEST(TypedAnswer, ANumberHasOneReading) {
  Question number = many_points();
  number.kind = QuestionKind::number;
  const std::vector<Answer> answers = {{"percent", 1.125}};
  EXPECT_EQ(typed_into_a_form({number}, answers), answers);
}

}  // namespace
}  // namespace foveola::study
